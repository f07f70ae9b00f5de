// For: oit_buffers.h
// OIT_STORE_FETCH: the nearest layers of a pass, held in the attachments and changed in place by the fragments of a pixel, one
// after the other as they are drawn.
layout(location = 0) inout highp uvec4 oit_layer_0;
layout(location = 1) inout highp uvec4 oit_layer_1;
layout(location = 2) inout highp uvec4 oit_layer_2;
#if OIT_FETCHED == 7
layout(location = 3) inout highp uvec4 oit_layer_3;
layout(location = 4) inout highp uvec4 oit_layer_4;
layout(location = 5) inout highp uvec4 oit_layer_5;
layout(location = 6) inout highp uvec4 oit_layer_6;
#define OIT_EACH_LAYER(X) \
    X(oit_layer_0) X(oit_layer_1) X(oit_layer_2) X(oit_layer_3) X(oit_layer_4) X(oit_layer_5) X(oit_layer_6)
#else
#define OIT_EACH_LAYER(X) X(oit_layer_0) X(oit_layer_1) X(oit_layer_2)
#endif
// How many were like the last one that was composed; how many there were.
layout(location = OIT_FETCHED) inout highp uvec2 oit_seen;
