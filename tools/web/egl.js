// What emscripten's EGL lacks. Programs that ask for a platform's display fall back to the default one.
mergeInto(LibraryManager.library, {
    eglGetPlatformDisplay: function (platform, display, attributes) {
        return 0;
    },
});
