// For: transparency.h
// Fragment stage. Which layers of a semantic group are shown: a chain from the front-most face on.
//
// A layer whose owner was not written is not of the group or too far away; one of an object that an earlier layer shows
// is that object's next face, which never shines through. Either ends the chain.
#if TR_CHAIN
uniform highp sampler2DArray tr_front_owner; // by layer: ids as depths, 1 where none was written

// How many of the first `count` layers are shown.
int tr_chain(ivec2 pixel, int count)
{
    for (int i = 1; i < count; ++i) {
        highp float owner = texelFetch(tr_front_owner, ivec3(pixel, i), 0).r;
        if (owner == 1.0)
            return i;
        for (int j = 0; j < i; ++j)
            if (texelFetch(tr_front_owner, ivec3(pixel, j), 0).r == owner)
                return i;
    }
    return count;
}
#endif
