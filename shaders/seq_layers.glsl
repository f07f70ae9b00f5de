// For: transparency.h
// Layers of TR_SEE_EXACT: whose each is, front to back. The codes of units, with what is known of the layer in bits that
// those leave free.
#define TR_LAYER_LAST (1u << 21)       // no mask looks through it, or there is nothing
#define TR_LAYER_NONE (1u << 22)       // there is none
#define TR_LAYER_COINCIDENT (1u << 23) // at the same depth as the one before

// What of an occluder a mask lets be, of a target's importance: an occluder that is a target counts one less.
highp float tr_yields(highp float importance, highp uint code)
{
    highp float occluder = float(code >> 24) * (1.0 / 255.0);
    if ((code & TR_CODE_CLOSES) != 0u)
        return 0.0;
    return clamp(importance - ((code & TR_CODE_TARGET) != 0u ? occluder - 1.0 : occluder), 0.0, 1.0);
}
