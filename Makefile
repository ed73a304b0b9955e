# make demo   installs what is missing, builds, and plans the mock-up's tubes
# make test   the same, and runs every test
TUBES   ?= spread:60
TOUCHES ?= auto
SEED    ?= 1
OUT     ?= out/demo
JOBS    ?= $(shell nproc)

BUILD := build
SUDO  := $(shell [ "$$(id -u)" = 0 ] || echo sudo)

.PHONY: demo test program packages format clean
.DEFAULT_GOAL := demo

demo: program
	$(BUILD)/tubeplan plan app/cells/mockup.yaml --tubes $(TUBES) --touches $(TOUCHES) --truth app/cells/mockup-true.yaml --seed $(SEED) --out $(OUT)

test: $(BUILD)/build.ninja
	cmake --build $(BUILD) -j $(JOBS)
	ctest --test-dir $(BUILD) --output-on-failure --no-tests=error -j $(JOBS)

program: $(BUILD)/build.ninja
	@cmake --build $(BUILD) -j $(JOBS) --target tubeplan

$(BUILD)/build.ninja: $(BUILD)/.packages CMakePresets.json
	cmake --preset release
	@touch $@

packages: $(BUILD)/.packages

# The stamp stands for "all of packages.txt is installed"; only what is missing is fetched.
$(BUILD)/.packages: packages.txt
	@missing=; for package in $$(grep -v '^#' packages.txt); do \
	  dpkg-query -W -f '$${Status}' $$package 2>/dev/null | grep -q 'ok installed' || missing="$$missing $$package"; \
	done; \
	if [ -n "$$missing" ]; then \
	  echo "installing:$$missing"; \
	  $(SUDO) apt-get update && \
	  $(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $$missing || exit 1; \
	fi
	@mkdir -p $(BUILD) && touch $@

format:
	clang-format -i $$(git ls-files '*.cpp' '*.hpp')

clean:
	rm -rf $(BUILD) build-dev build-asan
