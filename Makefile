# make demo   installs what is missing, builds, finds the mock-up's stiffnesses by a campaign, and plans its tubes
# make test   the same with the packages of the tests, and runs every test
# make everything  compiles all that is in the tree: tests, benchmarks and studies too
# make package  the same as demo's build, and a Debian package of it in build/
# make site   the documents, every command, the catalogue of effects and the libraries' headers as a site in build/site/html
# make sanitize  every test under the address, undefined-behaviour and thread sanitizers (clang; long): sanitize-libraries,
#                sanitize-program and sanitize-threads in a row
# make pictures  the pictures of the documents, taken anew
# make diagrams  the diagrams of the documents, drawn from docs/diagrams
# make coverage  lines and branches that the tests run, by folder (clang)
# make mutants  mutants of what results hang on, and which of them no test kills (an hour or more)
# make clean-root ROOT=FOLDER  the package in a Debian of its own: installed, planned, opened, linked (as root)
# make bench  the same, and times everything that has a goal, and its peer if there is one: docs/benchmarks.md
TUBES   ?= spread:60
TOUCHES ?= auto
SEED    ?= 1
OUT     ?= out/demo
JOBS    ?= $(shell nproc)

space := $(subst ,, )
BUILD := build
BENCH := build-bench
SUDO  := $(shell [ "$$(id -u)" = 0 ] || echo sudo)

.PHONY: demo test everything sanitize sanitize-libraries sanitize-program sanitize-threads coverage mutants clean-root bench package site pictures diagrams program packages format clean
.DEFAULT_GOAL := demo

# Two stages, as in the thesis: the stiffnesses from a campaign of touched holes, then the base from three touches. An arm
# whose stiffnesses are those of the drawing fits neither, and would be planned by a wrong model.
STIFFNESSES := tool.joint_stiffness.z,forearm.joint_stiffness.z,latch-link.beam.Iz,mezzanine-beam.beam.Iz,mezzanine-beam.joint_stiffness.z,mezzanine-platform.joint_stiffness.x

demo: program
	$(BUILD)/tubeplan simulate app/cells/mockup-true.yaml --design app/cells/mockup-campaign.yaml --seed 5 --out $(OUT)/campaign
	$(BUILD)/tubeplan identify app/cells/mockup.yaml $(OUT)/campaign/measurements.csv --free $(STIFFNESSES) --out $(OUT)/campaign/identified.yaml
	$(BUILD)/tubeplan plan $(OUT)/campaign/identified.yaml --tubes $(TUBES) --touches $(TOUCHES) --truth app/cells/mockup-true.yaml --seed $(SEED) --out $(OUT)

test: $(BUILD)/.tests
	cmake --build $(BUILD) -j $(JOBS)
	ctest --test-dir $(BUILD) --output-on-failure --no-tests=error -j $(JOBS); \
	  code=$$?; python3 tests/skipped.py $(BUILD); exit $$code

pictures: $(BUILD)/.tests
	cmake --build $(BUILD) -j $(JOBS)
	TUBEPLAN=$(BUILD)/tubeplan TUBEPLAN_WEB=$(BUILD)/web node tests/web/docs_pictures.mjs

diagrams: $(BUILD)/.packages-docs
	for diagram in docs/diagrams/*.dot; do dot -Tsvg $$diagram -o $${diagram%.dot}.svg || exit 1; done
	python3 docs/diagrams/frames.py docs/diagrams/frames.svg

everything: $(BUILD)/.tests $(BENCH)/.packages
	cmake --preset release -DTUBEPLAN_TESTS=ON -DTUBEPLAN_BENCHMARKS=ON -DTUBEPLAN_STUDIES=ON
	cmake --build $(BUILD) -j $(JOBS)

bench: $(BENCH)/build.ninja
	@cmake --build $(BENCH) -j $(JOBS) --target bench

package: program $(BUILD)/.packages-deb
	cd $(BUILD) && SOURCE_DATE_EPOCH=$$(git -C .. log -1 --format=%ct) cpack -G DEB

# The suite under the address and undefined-behaviour sanitizers, the libraries before the program, so that a find comes early.
# Each of their test programs runs as one process: what its tests share is made once, which takes long here.
LIBRARY_TESTS := tubesheets_test deflection_test calibration_test planner_test visit_plan_test

sanitize: sanitize-libraries sanitize-program sanitize-threads

build-asan/build.ninja: $(BUILD)/.packages-sanitize CMakePresets.json
	cmake --preset asan
	@touch $@

sanitize-libraries: build-asan/build.ninja
	for test in $(LIBRARY_TESTS); do \
	  cmake --build build-asan -j $(JOBS) --target $$test && \
	  (cd $$(dirname build-asan/tests/*/$$test) && ./$$test --gtest_brief=1) || exit 1; \
	done

sanitize-program: build-asan/build.ninja
	cmake --build build-asan -j $(JOBS)
	ctest --test-dir build-asan -LE web -E '^($(subst $(space),|,$(LIBRARY_TESTS)))\.' --output-on-failure --no-tests=error -j $(JOBS)

# What runs in parallel, under the thread sanitizer.
sanitize-threads: $(BUILD)/.packages-sanitize
	tests/sanitize/thread_tbb.sh build-tsan/tbb
	cmake --preset tsan -DTBB_DIR=$(CURDIR)/build-tsan/tbb/installed/lib/cmake/TBB
	cmake --build build-tsan -j $(JOBS)
	TSAN_OPTIONS=suppressions=$(CURDIR)/tests/sanitize/thread.supp ctest --test-dir build-tsan -LE web --output-on-failure --no-tests=error -j $(JOBS) -R 'campaign|Plan|Diagnos|Workbench|Jobs|Batch'

# Without the tests of faults: they look at which files a program leaves, and the counts are one.
coverage: $(BUILD)/.packages-sanitize
	cmake --preset coverage
	cmake --build build-coverage -j $(JOBS)
	LLVM_PROFILE_FILE=$(CURDIR)/build-coverage/profiles/%4m.profraw ctest --test-dir build-coverage -LE web -E "^faults" --output-on-failure --no-tests=error -j $(JOBS)
	python3 tests/coverage.py build-coverage

mutants: $(BUILD)/.tests
	cmake --build $(BUILD) -j $(JOBS)
	python3 tests/mutation/mutants.py $(BUILD)

clean-root: package
	tests/package/clean_root.sh $(BUILD)/tubeplan_*.deb $(ROOT)

site: program $(BUILD)/.packages-docs
	python3 docs/site/make_site.py $(BUILD)/tubeplan $(BUILD)/site

program: $(BUILD)/build.ninja
	@cmake --build $(BUILD) -j $(JOBS) --target installed

$(BUILD)/build.ninja: $(BUILD)/.packages CMakePresets.json
	cmake --preset release -DTUBEPLAN_TESTS=OFF
	@touch $@

# The tests in the same build folder; what they alone need is installed with them.
$(BUILD)/.tests: $(BUILD)/build.ninja $(BUILD)/.packages-test
	cmake --preset release -DTUBEPLAN_TESTS=ON
	@touch $@

$(BENCH)/build.ninja: $(BENCH)/.packages CMakePresets.json
	cmake --preset release -B $(BENCH) -DTUBEPLAN_BENCHMARKS=ON -DTUBEPLAN_TESTS=OFF
	@touch $@

packages: $(BUILD)/.packages

$(BUILD)/.packages: packages.txt
$(BUILD)/.packages-test: packages-test.txt
$(BENCH)/.packages: packages.txt packages-bench.txt
$(BUILD)/.packages-deb: packages-deb.txt
$(BUILD)/.packages-docs: packages-docs.txt
$(BUILD)/.packages-sanitize: packages.txt packages-test.txt packages-sanitize.txt

# The stamp stands for "all of its lists is installed"; only what is missing is fetched. A package whose command is there
# from elsewhere counts as installed: Node.js's own packages bring npm and do not go with Debian's.
$(BUILD)/.packages $(BUILD)/.packages-test $(BENCH)/.packages $(BUILD)/.packages-deb $(BUILD)/.packages-docs $(BUILD)/.packages-sanitize:
	@missing=; for package in $$(grep -hv '^#' $^); do \
	  dpkg-query -W -f '$${Status}' $$package 2>/dev/null | grep -q 'ok installed' || command -v $$package >/dev/null || missing="$$missing $$package"; \
	done; \
	if [ -n "$$missing" ]; then \
	  echo "installing:$$missing"; \
	  $(SUDO) apt-get update && \
	  $(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $$missing || exit 1; \
	fi
	@mkdir -p $(@D) && touch $@

format:
	clang-format -i $$(git ls-files '*.cpp' '*.hpp')

clean:
	rm -rf $(BUILD) $(BENCH) build-dev build-asan build-fuzz build-coverage build-tsan
