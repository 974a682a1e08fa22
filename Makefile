# The two commands are `make verify` and `make test`; `make help` lists the others.
# Everything is built by CMake (CMakePresets.json) below build/.

packages      := g++ cmake ninja-build pkg-config libginac-dev libcln-dev libboost-dev \
                 libcli11-dev libfmt-dev nlohmann-json3-dev libmimalloc-dev
tex_packages  := texlive-luatex texlive-latex-recommended texlive-pictures latexmk fonts-cmu \
                 texlive-lang-czechslovak texlive-lang-european texlive-lang-cyrillic \
                 poppler-utils librsvg2-bin
coq_packages  := coq libcoq-coquelicot
test_packages := catch2 clang-14 libclang-rt-14-dev python3-sympy parallel $(tex_packages) \
                 $(coq_packages)
bench_packages := python3-sympy python3-gmpy2 maxima singular-ui singular-modules pari-gp libflint-dev
program       := build/release/bin/patchproof
build         := cmake --build -j $(shell nproc) --preset
run_tests     := ctest -j $(shell nproc) --preset

.PHONY: help verify program test test-release test-sanitize test-clang test-fuzz \
        packages test-packages with-tests claims certified golden bench format clean
.DEFAULT_GOAL := help
# One step after the other under any -j; the steps themselves use all processors.
.NOTPARALLEL:

help:
	@echo 'make verify   build the program and decide every case in cases/'
	@echo 'make test     run every test: plain, with sanitizers, with clang, and a short fuzz run'
	@echo 'make program  only build $(program)'
	@echo 'make claims   write docs/claims.md anew: every item of the notes with its verdicts'
	@echo 'make certified  certify every claim of cases/ with coqc; write the table of docs/trust.md anew'
	@echo 'make golden   write the golden documents of tests/golden anew, to be read before they are kept'
	@echo 'make bench    time patchproof and other systems on the same claims; QUICK=1: under five minutes'
	@echo 'make format   format the sources'
	@echo 'make clean    delete build/'

verify: program
	@$(program) check cases --engines both

program: packages build/release/build.ninja
	@$(build) release --target patchproof_program

# In this order: what fails soonest first, and CTest's closing lines last.
test: test-packages test-release test-clang test-fuzz test-sanitize

test-release: test-packages with-tests
	@$(build) release
	@$(run_tests) release

test-sanitize: test-packages build/sanitize/build.ninja
	@$(build) sanitize
	@$(run_tests) sanitize

test-clang: test-packages build/clang/build.ninja
	@$(build) clang --target patchproof_program

test-fuzz: test-packages build/fuzz/build.ninja
	@$(build) fuzz
	@$(run_tests) fuzz

packages:
	@cmake/install_packages $(packages)

test-packages:
	@cmake/install_packages $(packages) $(test_packages)

# CMake itself notices changes of the CMake files; only the presets are ours to watch.
# `make verify` needs no Catch2, so it starts without the tests; `make test` adds them later.
build/%/build.ninja: CMakePresets.json | packages
	@cmake --fresh --preset $* $(if $(filter release,$*),-DBUILD_TESTING=OFF)
	@touch $@

with-tests: build/release/build.ninja
	@grep -q '^BUILD_TESTING:BOOL=ON' build/release/CMakeCache.txt || \
	  cmake --preset release -DBUILD_TESTING=ON

claims: test-packages with-tests
	@$(build) release
	@PATCHPROOF_WRITE_CLAIMS=1 build/release/tests/unit_tests '[#docs/claims]'

certified: test-packages with-tests
	@$(build) release
	@PATCHPROOF_WRITE_CERTIFIED=1 build/release/tests/unit_tests '[#docs/certified]'
	@$(program) certify cases -o build/certificates --check

golden: test-packages with-tests
	@$(build) release
	@PATCHPROOF_WRITE_GOLDEN=1 build/release/tests/unit_tests '[#latex/golden]'
	@PATCHPROOF_WRITE_GOLDEN=1 build/release/tests/unit_tests '[#derivation/walk]'

# BENCH_OPTIONS is handed on, such as --only W1; docs/performance.md says what is measured.
bench: packages build/release/build.ninja
	@cmake/install_packages $(bench_packages)
	@grep -q '^PATCHPROOF_BENCH:BOOL=ON' build/release/CMakeCache.txt || \
	  cmake --preset release -DPATCHPROOF_BENCH=ON
	@$(build) release --target bench_programs
	@python3 -B bench/run.py $(if $(QUICK),--quick) $(BENCH_OPTIONS)

format:
	@cmake/install_packages clang-format
	@find bench lib recheck verify tests -name '*.[ch]pp' -o -name '*.[ch]' | xargs clang-format -i

clean:
	@rm -rf build
