#include "headless.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef const unsigned char *(EGLAPIENTRY *get_string_fn)(unsigned);
typedef void(EGLAPIENTRY *get_integer_fn)(unsigned, int *);
enum { GL_VENDOR_ = 0x1F00, GL_RENDERER_ = 0x1F01, GL_VERSION_ = 0x1F02, GL_MAJOR_ = 0x821B, GL_MINOR_ = 0x821C };

typedef struct request {
    int major, minor;
    bool es;
    char *message;
    size_t message_size;
} request;

void (*headless_get_proc(const char *name))(void) {
    return (void (*)(void))eglGetProcAddress(name);
}

/* Extension names are whole words: one may begin with another. */
static bool has_word(const char *words, const char *word) {
    size_t length = strlen(word);
    for (const char *at = words; at && (at = strstr(at, word)) != NULL; at += length)
        if ((at == words || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
            return true;
    return false;
}

static bool has_extension(EGLDisplay display, const char *name) {
    return has_word(eglQueryString(display, EGL_EXTENSIONS), name);
}

static void complain(const request *r, const char *platform, const char *what) {
    size_t length = strlen(r->message);
    snprintf(r->message + length, r->message_size - length, "%s%s: %s", length ? "; " : "", platform, what);
}

void headless_destroy(headless *h) {
    if (h->display) {
        eglMakeCurrent(h->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (h->context)
            eglDestroyContext(h->display, h->context);
        if (h->surface)
            eglDestroySurface(h->display, h->surface);
        eglTerminate(h->display);
    }
    memset(h, 0, sizeof *h);
}

/* ---- one display ----------------------------------------------------------------------------------------- */

static EGLConfig choose_config(EGLDisplay display, bool es, bool pbuffer) {
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE,
                             es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT,
                             EGL_SURFACE_TYPE,
                             pbuffer ? EGL_PBUFFER_BIT : 0,
                             EGL_RED_SIZE,
                             8,
                             EGL_GREEN_SIZE,
                             8,
                             EGL_BLUE_SIZE,
                             8,
                             EGL_NONE};
    EGLConfig config = NULL;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count < 1)
        return NULL;
    return config;
}

static EGLContext create_version(EGLDisplay display, EGLConfig config, int major, int minor, bool es) {
    const EGLint desktop[] = {
        EGL_CONTEXT_MAJOR_VERSION,           major,   EGL_CONTEXT_MINOR_VERSION, minor, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLint embedded[] = {EGL_CONTEXT_MAJOR_VERSION, major, EGL_CONTEXT_MINOR_VERSION, minor, EGL_NONE};
    return eglCreateContext(display, config, EGL_NO_CONTEXT, es ? embedded : desktop);
}

static EGLContext create_context(EGLDisplay display, EGLConfig config, const request *r) {
    static const int desktop[][2] = {{4, 6}, {4, 5}, {4, 4}, {4, 3}, {4, 2}, {4, 1}, {4, 0}, {3, 3}};
    static const int embedded[][2] = {{3, 2}, {3, 1}, {3, 0}};
    if (r->major)
        return create_version(display, config, r->major, r->minor, r->es);
    size_t count = r->es ? sizeof embedded / sizeof embedded[0] : sizeof desktop / sizeof desktop[0];
    EGLContext context = EGL_NO_CONTEXT;
    for (size_t i = 0; i < count && context == EGL_NO_CONTEXT; i++) {
        const int *version = r->es ? embedded[i] : desktop[i];
        context = create_version(display, config, version[0], version[1], r->es);
    }
    return context;
}

static void copy_string(char *out, size_t size, const unsigned char *text) {
    snprintf(out, size, "%s", text ? (const char *)text : "unknown");
}

static bool is_software(const char *renderer) {
    static const char *const names[] = {"llvmpipe", "softpipe", "swrast", "SWR", "SwiftShader", "Software"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++)
        if (strstr(renderer, names[i]))
            return true;
    return false;
}

static bool describe(headless *h) {
    get_string_fn get_string = (get_string_fn)eglGetProcAddress("glGetString");
    get_integer_fn get_integer = (get_integer_fn)eglGetProcAddress("glGetIntegerv");
    if (!get_string || !get_integer)
        return false;
    copy_string(h->vendor, sizeof h->vendor, get_string(GL_VENDOR_));
    copy_string(h->renderer, sizeof h->renderer, get_string(GL_RENDERER_));
    copy_string(h->version, sizeof h->version, get_string(GL_VERSION_));
    get_integer(GL_MAJOR_, &h->major);
    get_integer(GL_MINOR_, &h->minor);
    h->software = is_software(h->renderer);
    return true;
}

/* What is missing, NULL where the context is current. */
static const char *open_context(headless *h, const request *r) {
    if (!eglBindAPI(r->es ? EGL_OPENGL_ES_API : EGL_OPENGL_API))
        return r->es ? "no OpenGL ES" : "no desktop OpenGL";
    bool surfaceless = has_extension(h->display, "EGL_KHR_surfaceless_context");
    EGLConfig config = choose_config(h->display, r->es, !surfaceless);
    if (!config && !(surfaceless && has_extension(h->display, "EGL_KHR_no_config_context")))
        return "no usable EGL configuration";
    h->context = create_context(h->display, config, r);
    if (h->context == EGL_NO_CONTEXT)
        return r->es ? "no OpenGL ES 3 context of that version" : "no OpenGL core context of that version";
    if (!surfaceless) {
        const EGLint one_pixel[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
        h->surface = eglCreatePbufferSurface(h->display, config, one_pixel);
        if (!h->surface)
            return "no pixel buffer surface";
    }
    EGLSurface surface = h->surface ? h->surface : EGL_NO_SURFACE;
    if (!eglMakeCurrent(h->display, surface, surface, h->context))
        return "the context cannot be made current";
    return describe(h) ? NULL : "no GL functions";
}

static bool open_display(headless *h, EGLDisplay display, const char *platform, const request *r) {
    memset(h, 0, sizeof *h);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, NULL, NULL)) {
        complain(r, platform, "no EGL display");
        return false;
    }
    h->display = display;
    h->platform = platform;
    h->es = r->es;
    const char *missing = open_context(h, r);
    if (missing) {
        complain(r, platform, missing);
        headless_destroy(h);
    }
    return !missing;
}

/* ---- which display --------------------------------------------------------------------------------------- */

/* Whether a candidate ends the search: the first hardware driver does, the first software one is kept until then. Which
 * context is current afterwards is settled at the end of the search. */
static bool take(headless *best, headless *candidate, bool software_is_fine) {
    if (!best->display) {
        *best = *candidate;
    } else if (best->software && !candidate->software) {
        headless_destroy(best);
        *best = *candidate;
    } else {
        headless_destroy(candidate);
    }
    return software_is_fine || !best->software;
}

static EGLDisplay platform_display(EGLenum platform, void *native) {
    PFNEGLGETPLATFORMDISPLAYEXTPROC get =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
    return get ? get(platform, native, NULL) : EGL_NO_DISPLAY;
}

static bool device_is_software(EGLDeviceEXT device) {
    PFNEGLQUERYDEVICESTRINGEXTPROC query = (PFNEGLQUERYDEVICESTRINGEXTPROC)eglGetProcAddress("eglQueryDeviceStringEXT");
    return query && has_word(query(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
}

/* All devices of the machine. Where a software driver is in hand already, the software device is not tried again. */
static bool try_devices(headless *best, const request *r, bool software_is_fine) {
    enum { MOST = 32 };
    EGLDeviceEXT devices[MOST];
    EGLint count = 0;
    PFNEGLQUERYDEVICESEXTPROC query = (PFNEGLQUERYDEVICESEXTPROC)eglGetProcAddress("eglQueryDevicesEXT");
    if (!query || !query(MOST, devices, &count))
        return false;
    for (EGLint i = 0; i < count; i++) {
        headless candidate;
        bool software = device_is_software(devices[i]);
        if (software ? best->display != NULL : software_is_fine)
            continue;
        if (open_display(&candidate, platform_display(EGL_PLATFORM_DEVICE_EXT, devices[i]), "device", r) &&
            take(best, &candidate, software_is_fine))
            return true;
    }
    return false;
}

static bool software_asked_for(void) {
    const char *value = getenv("LIBGL_ALWAYS_SOFTWARE");
    return value && *value && strcmp(value, "0") != 0 && strcmp(value, "false") != 0;
}

bool headless_create(headless *h, int major, int minor, bool es, char *message, size_t message_size) {
    request r = {major, minor, es, message, message_size};
    headless candidate;
    bool software_is_fine = software_asked_for(), done = false;
    memset(h, 0, sizeof *h);
    message[0] = '\0';
    const char *client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (has_word(client, "EGL_MESA_platform_surfaceless") &&
        open_display(&candidate, platform_display(EGL_PLATFORM_SURFACELESS_MESA, NULL), "surfaceless", &r))
        done = take(h, &candidate, software_is_fine);
    if (!done && has_word(client, "EGL_EXT_platform_device"))
        done = try_devices(h, &r, software_is_fine);
    if (!done && !h->display && open_display(&candidate, eglGetDisplay(EGL_DEFAULT_DISPLAY), "default", &r))
        take(h, &candidate, true);
    if (!h->display && !message[0])
        snprintf(message, message_size, "EGL finds no display");
    if (h->display) {
        EGLSurface surface = h->surface ? h->surface : EGL_NO_SURFACE;
        eglBindAPI(es ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
        eglMakeCurrent(h->display, surface, surface, h->context);
        message[0] = '\0';
    }
    return h->display != NULL;
}
