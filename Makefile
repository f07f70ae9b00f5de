# Glassine. `make help` lists what there is to make. Everything is built below build/.
#
# Variables:  config=release|debug|asan   how things are compiled; release, the default, is built in build/ itself
#             BENCH=quick                 benchmarks that finish in a minute
#             FUZZ_RUNS=N                 how many inputs `make fuzz` tries
#             V=1                         print each command
#             DEPS=skip                   do not look for missing Debian packages
#             PREFIX, DESTDIR             where `make install` puts things

config ?= release
jobs ?= $(shell nproc)
PREFIX ?= /usr/local
FUZZ_RUNS ?= 200000
CC := $(if $(filter default,$(origin CC)),gcc,$(CC))

warnings := -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wdouble-promotion -Wundef -Werror
flags_release := -O2 -g
flags_debug := -O0 -g3
# The sanitizers are clang's, so that both compilers see every file with every warning.
flags_asan := -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
override CC := $(if $(filter asan,$(config)),clang,$(CC))
# Prints what is made and not how; V=1 prints how as well.
say = $(if $(V),,@echo '  $(1)'; )
out := build$(if $(filter-out release,$(config)),/$(config))
flags := -std=c11 $(flags_$(config)) $(warnings) $(CFLAGS)
includes := -I. -Iexamples -isystem build/glad/include
# For programs that are compiled and linked in one go; objects need no names.
depends = -MMD -MP -MT $@ -MF $@.d
program_libraries := -lassimp -lEGL -lm
libraries := -Wl,--as-needed -lcmocka $(program_libraries)
ifeq ($(flags_$(config)),)
$(error config=$(config) is not one of release, debug, asan)
endif

headers := silhouette.h transparency.h oit_buffers.h shaders_embedded.h
example_modules := $(filter-out illustrate rts minimal_%,$(basename $(notdir $(sort $(wildcard examples/*.c)))))
unit_tests := $(patsubst tests/%.c,$(out)/tests/%,$(sort $(wildcard tests/unit_*.c)))
mock_tests := $(patsubst tests/%.c,$(out)/tests/%,$(sort $(wildcard tests/mock_*.c)))
gl_tests := $(patsubst tests/%.c,$(out)/tests/%,$(sort $(wildcard tests/gl_*.c)))
fuzzers := $(patsubst tests/%.c,build/fuzz/%,$(sort $(wildcard tests/fuzz_*.c)))
# `make accuracy` runs bench/accuracy.c.
benchmarks := $(patsubst bench/%.c,build/bench/%,$(filter-out bench/accuracy.c,$(sort $(wildcard bench/*.c))))
formatted := $(wildcard *.h examples/*.[ch] examples/*/*.[ch] tests/*.[ch] tests/compile/*.[ch] tools/*.[ch] bench/*.[ch])
glad := build/glad/include/glad/gl.h
clang_format := $(firstword $(shell command -v clang-format-14 clang-format) clang-format-14)
# A fresh make, so that packages are there before anything is built; parallel unless the caller chose a number of jobs.
build = @+$(MAKE) --no-print-directory $(if $(filter -j% --jobserver%,$(MAKEFLAGS)),,-j$(jobs))

.PHONY: help demo test deps shaders check-generated check-shaders headers-alone sanitize valgrind fuzz format \
        check-format tsan bench bench-silhouette bench-distance bench-view-dependent bench-oit bench-lines bench-flicker \
        bench-dynamic bench-smart accuracy web ci install uninstall clean run-tests
.DELETE_ON_ERROR:
.SECONDARY:

help: ## list these targets
	@awk -F ':.*## ' '/^[a-z-]+:.*## /{printf "make %-16s %s\n", $$1, $$2}' Makefile

demo: deps ## render at least six pictures into build/gallery
	$(build) build/illustrate build/rts build/sheet
	@tools/gallery build/illustrate build/rts build/gallery

test: deps ## build and run all tests
	$(build) run-tests

deps: ## install the Debian packages that are missing; instant when none is
	@tools/install-deps

shaders: build/embed_shaders ## write shaders/ into the headers
	@build/embed_shaders .

check-generated: build/embed_shaders ## fail if a header is not what `make shaders` would write
	@build/embed_shaders . --check

check-shaders: build/dump_shaders ## validate the text of every shader stage for every GLSL version
	@tools/check_shaders build/dump_shaders build/shaders

headers-alone: ## compile each header by itself: C and C++ by gcc, clang, tcc and mingw, all include orders
	@tests/compile/headers_alone build/compile

sanitize: build/embed_shaders ## unit, mock and GL tests and illustrate under AddressSanitizer and UndefinedBehaviorSanitizer
	$(build) config=asan run-sanitized

# Tests that take a second or more are left out, as they would take minutes; the fuzzer asks the same functions for less.
too_long_for_valgrind := $(patsubst %,build/tests/unit_%,battlefield candidates containment extraction_fast models \
    reference reference_dynamic)
valgrind: $(filter-out $(too_long_for_valgrind),$(unit_tests)) $(mock_tests) build/fuzz_silhouette | build/embed_shaders ## unit and mock tests, and some fuzzing, under valgrind
	@tools/run_suites $(patsubst %,'valgrind -q --error-exitcode=9 --leak-check=full %',$(filter-out %/fuzz_silhouette,$^)) \
	    'valgrind -q --error-exitcode=9 --leak-check=full build/fuzz_silhouette 3000 1'

tsan: tests/unit_threads.c ## one mesh in many threads, under ThreadSanitizer
	@mkdir -p build/tsan
	$(call say,CC      build/tsan/unit_threads)clang -std=c11 -g -O1 -fsanitize=thread $(warnings) $(includes) $< -o build/tsan/unit_threads -lcmocka -lpthread -lm
	@tools/run_suites build/tsan/unit_threads

fuzz: $(fuzzers) ## the inputs in tests/corpus, then FUZZ_RUNS random ones, to every fuzz target
	@tools/run_suites $(foreach c,$(notdir $(wildcard tests/corpus/*)),'build/fuzz/fuzz_$c -timeout=10 tests/corpus/$c/*') \
	    $(patsubst %,'% -runs=$(FUZZ_RUNS) -seed=1 -timeout=10 -verbosity=0 -artifact_prefix=build/fuzz/',$^)

format: ## lay out all C files by .clang-format
	@$(clang_format) -i $(formatted)

check-format: ## fail if a C file is not laid out by .clang-format
	@$(clang_format) --dry-run -Werror $(formatted)

bench: $(benchmarks) ## run the benchmarks; tables and build/bench/*.csv. One alone: bench-distance, bench-lines, ...
	@set -e; for program in $^; do BENCH=$(BENCH) $$program; done

bench-silhouette: build/bench/silhouette build/bench/gauss_map ## silhouettes against the published test, Gauss map, cones and VTK
	@mkdir -p build/bench/meshes
	@BENCH=$(BENCH) BENCH_MESHES=build/bench/meshes build/bench/silhouette
	@BENCH=$(BENCH) build/bench/gauss_map
	@/usr/bin/python3 bench/vtk_feature_lines.py build/bench/meshes build/bench/silhouette.csv
	@if command -v gnuplot >/dev/null; then gnuplot -c bench/silhouette.gp build/bench/silhouette.csv build/bench/silhouette.png; fi

bench-oit: build/bench/oit ## fragment stores against blending, peeling, weighted blending, and VTK where it and xvfb-run are
	@mkdir -p build/bench/scenes
	@BENCH=$(BENCH) BENCH_SCENES=build/bench/scenes build/bench/oit
	@if command -v xvfb-run >/dev/null; then xvfb-run -a -s "-screen 0 1280x1024x24" \
	    env LIBGL_ALWAYS_SOFTWARE=1 /usr/bin/python3 bench/vtk_transparency.py build/bench/scenes build/bench/oit.csv; fi

bench-distance bench-view-dependent bench-lines bench-flicker bench-dynamic bench-smart: bench-%: ## one benchmark: bench-NAME runs bench/NAME.c
	@$(MAKE) --no-print-directory build/bench/$(subst -,_,$*)
	@BENCH=$(BENCH) build/bench/$(subst -,_,$*)

accuracy: build/bench/accuracy ## error against time of every knob: tables and pictures in build/accuracy
	@build/bench/accuracy build/accuracy

web: ## the smallest example for WebGL 2, by emscripten; chromium shows it and it is compared with GL 3.3
	@tools/check_web build/web

mutants: $(glad) ## break named lines one at a time and show that a test notices
	@tools/mutants build/mutants

ci: deps ## everything that must pass before a change is taken
	@tools/run_ci $(MAKE) test sanitize valgrind tsan check-shaders check-format fuzz

install: build/illustrate ## install the headers below $(PREFIX)/include/glassine and the program illustrate
	install -d $(DESTDIR)$(PREFIX)/include/glassine $(DESTDIR)$(PREFIX)/bin
	install -m 644 $(headers) $(DESTDIR)$(PREFIX)/include/glassine
	install -m 755 build/illustrate $(DESTDIR)$(PREFIX)/bin

uninstall: ## remove what `make install` installed
	rm -f $(patsubst %,$(DESTDIR)$(PREFIX)/include/glassine/%,$(headers)) $(DESTDIR)$(PREFIX)/bin/illustrate
	-rmdir $(DESTDIR)$(PREFIX)/include/glassine

clean: ## remove build/
	rm -rf build

# A second implementation; and drivers that have no more, and take no newer shaders, than GL 3.3 and ES 3.0.
softpipe := env GALLIUM_DRIVER=softpipe GLASSINE_MAX_GL=330
oldest := env LIBGL_ALWAYS_SOFTWARE=1 MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330 \
    MESA_GLES_VERSION_OVERRIDE=3.0 GLASSINE_MAX_GL=330 GLASSINE_MAX_ES=300
run-tests: $(unit_tests) $(mock_tests) $(gl_tests) build/illustrate build/rts build/host build/embed_shaders $(glad)
	@tools/run_suites $(unit_tests) $(mock_tests) $(gl_tests) \
	    '$(softpipe) build/tests/gl_alpha' '$(softpipe) build/tests/gl_targets' \
	    $(foreach test,hosts transparency integration,'$(softpipe) build/tests/gl_$(test)' '$(oldest) build/tests/gl_$(test)') \
	    'tests/compile/headers_alone build/compile' 'build/embed_shaders . --check' \
	    'tests/compile/quick_starts build/quick_starts' 'tests/compile/minimal_examples build/minimal' \
	    'tests/compile/exports build/exports' 'tests/compile/loaders build/loaders' 'sh tests/test_illustrate.sh' 'sh tests/test_rts.sh' 'sh tests/test_host.sh'

# What a GL driver leaks is not ours to mend.
run-sanitized: $(unit_tests) $(mock_tests) $(gl_tests) $(out)/illustrate
	@tools/run_suites $(unit_tests) $(mock_tests) $(patsubst %,'env ASAN_OPTIONS=detect_leaks=0 %',$(gl_tests)) \
	    'env ASAN_OPTIONS=detect_leaks=0 sh tests/test_illustrate.sh $(out)/illustrate $(out)/test_illustrate'

$(glad):
	@mkdir -p build
	$(call say,GLAD    $@)/usr/bin/python3 -m glad --quiet --reproducible --merge --api gl:core=4.5,gles2=3.2 \
	    --extensions $(subst $() ,$(),$(glad_extensions)) --out-path build/glad c --header-only
glad_extensions := GL_KHR_debug,GL_EXT_clip_control,GL_EXT_color_buffer_float,GL_EXT_disjoint_timer_query, \
    GL_EXT_shader_framebuffer_fetch,GL_ARB_post_depth_coverage

$(out)/examples/%.o: examples/%.c | $(glad)
	@mkdir -p $(@D)
	$(call say,CC      $@)$(CC) $(flags) $(includes) -MMD -MP -c $< -o $@

$(out)/libexamples.a: $(example_modules:%=$(out)/examples/%.o)
	@rm -f $@
	$(call say,AR      $@)$(AR) rcs $@ $^

$(out)/illustrate: $(out)/examples/illustrate.o $(out)/libexamples.a
	$(call say,LINK    $@)$(CC) $(flags) $^ $(program_libraries) -o $@

# A window where there is a display; else pictures, by EGL.
$(out)/rts: $(out)/examples/rts.o $(out)/libexamples.a
	$(call say,LINK    $@)$(CC) $(flags) $^ $(program_libraries) -lglfw -o $@

# The engine that transparency.h is put into; docs/integration.md tells how.
$(out)/host: $(patsubst %.c,$(out)/%.o,$(sort $(wildcard examples/host/*.c))) $(out)/libexamples.a
	$(call say,LINK    $@)$(CC) $(flags) $^ $(program_libraries) -o $@

$(out)/tests/%: tests/%.c $(out)/libexamples.a | $(glad)
	@mkdir -p $(@D)
	$(call say,CC      $@)$(CC) $(flags) $(includes) $(depends) $< $(out)/libexamples.a $(libraries) -o $@

build/bench/%: bench/%.c build/libexamples.a | $(glad)
	@mkdir -p $(@D)
	$(call say,CC      $@)$(CC) $(flags) $(includes) $(depends) $< build/libexamples.a $(libraries) -o $@

build/fuzz/%: tests/%.c
	@mkdir -p $(@D)
	$(call say,FUZZER  $@)clang -std=c11 $(flags_asan) -fsanitize=fuzzer -DFUZZ_LIBFUZZER $(warnings) $(includes) $(depends) $< -lm -o $@

build/fuzz_silhouette: tests/fuzz_silhouette.c
	@mkdir -p $(@D)
	$(call say,CC      $@)$(CC) $(flags) $(includes) $(depends) $< -lm -o $@

build/%: tools/%.c
	@mkdir -p $(@D)
	$(call say,CC      $@)$(CC) $(flags) $(includes) $(depends) $< -lm -o $@

-include $(wildcard $(out)/*.d $(out)/*/*.d $(out)/*/*/*.d build/bench/*.d build/fuzz/*.d build/*.d)
