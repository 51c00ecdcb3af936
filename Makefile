# What a person types. Everything is done by CMake, CTest and the scripts in tools/.
.DEFAULT_GOAL := help
.PHONY: help install build demo test python docs package tiny golden sanitize thread format lint bench fuzz clean

help:  ## this list
	@sed -n 's/^\([a-z]*\):.*## /\1\t/p' Makefile | expand -t 12

install:  ## install what building and testing need (Debian 12)
	@tools/install

build: install  ## the program, the library and the tests, in build/release
	@mkdir -p build
	@cmake --preset release > build/configure.log 2>&1 || (cat build/configure.log; exit 1)
	@cmake --build --preset release

demo:  ## the program alone is built; a month of fires is generated, united, checked and drawn into build/demo
	@tools/demo

test: build  ## every test, with totals; then those of the Python package, and geopandas' own against it
	@tools/test release
	@tools/install --python
	@tools/python wheel test geopandas

python:  ## the Python package: a wheel in build/python/dist, installed into build/python/venv, and its tests
	@tools/install --python
	@tools/python

docs:  ## the documentation site, in build/docs/html
	@tools/install --docs
	@tools/docs

golden: install  ## writes the golden digests anew: after a change of bytes that is meant (CONTRIBUTING.md)
	@tools/golden --write

package:  ## the Debian package, in build/package
	@tools/install --package
	@mkdir -p build
	@cmake --preset package > build/configure.log 2>&1 || (cat build/configure.log; exit 1)
	@cmake --build --preset package
	@cd build/package && cpack

tiny: install  ## the tests with all constants of src/base/tuning.h tiny; SEED=7: drawn at random
	@tools/tiny $(if $(SEED),random $(SEED),tiny)

sanitize: install  ## the tests under the address and undefined-behaviour sanitizers
	@cmake --preset sanitize -DOBLAST_BUILD_PROGRAM=ON && cmake --build --preset sanitize && tools/test sanitize

thread: install  ## the tests under the thread sanitizer
	@tools/instrument-tbb
	@cmake --preset thread && cmake --build --preset thread && tools/test thread

format:  ## rewrite the formatting of every C++ file
	@tools/lint fix

lint: build  ## formatting and clang-tidy, as CI checks them
	@tools/lint

bench:  ## every workload and every peer, the stages, files to file; SCALE=full for the large sizes
	@tools/install --bench
	@bench/peers/install
	@cmake --preset bench && cmake --build --preset bench
	@bench/run --scale $(or $(SCALE),small)
	@build/bench/bench/oblast_stages --benchmark_out=build/bench/report/stages.json
	@bench/end_to_end --scale $(or $(SCALE),small)
	$(if $(filter full,$(SCALE)),@bench/run --scale growth --peers '^$$' --output build/bench/report/growth)

fuzz:  ## the fuzzers, SECONDS_EACH seconds each (60)
	@tools/install --fuzz
	@cmake --preset fuzz && cmake --build --preset fuzz
	@tools/fuzz $(or $(SECONDS_EACH),60)

clean:  ## remove everything built
	@rm -rf build
