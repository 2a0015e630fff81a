# A thin door: every target is a command or two that you can also type.
PRESET ?= release
BUILD := build/$(PRESET)
DEMO := build/demo
JOBS ?= $(shell nproc)

.PHONY: deps build demo gallery test bench format lint accept clean

deps:
	@.ci/deps

build: deps
	cmake --preset $(PRESET)
	cmake --build $(BUILD) -j $(JOBS) --target surfgradc surfgrad-render

demo: build
	$(BUILD)/surfgradc compile materials/two_unwraps.json -o $(DEMO) --emit glsl
	$(BUILD)/surfgrad-render $(DEMO)/two_unwraps.json --texture-root materials -o $(DEMO)/two_unwraps.png \
	    --mesh torus --camera 0.6,2.1,2.9:0,-0.05,0:40 --size 720x440 --supersample 3
	@echo "wrote $(DEMO)/two_unwraps.png; the shader that drew it is $(DEMO)/two_unwraps.forward.frag.glsl"

gallery: build
	cmake --build $(BUILD) -j $(JOBS) --target surfgrad_gallery
	$(BUILD)/surfgrad-gallery materials/figures/*.figure.json -o build/gallery
	@echo "wrote build/gallery/index.html"

test: deps
	@cmake --preset $(PRESET)
	cmake --build $(BUILD) -j $(JOBS)
	@cmake --preset dev
	cmake --build build/dev -j $(JOBS) --target sanitized_tests
	ctest --test-dir build/dev -L sanitize -j $(JOBS) --output-on-failure
	ctest --test-dir $(BUILD) -j $(JOBS) --output-on-failure

bench: build
	cmake --build $(BUILD) -j $(JOBS) --target bench

format:
	git ls-files '*.cpp' '*.hpp' | xargs clang-format -i

lint: build
	git ls-files 'compiler/*.cpp' 'runtime/*.cpp' | xargs -P $(JOBS) -n 1 clang-tidy -p $(BUILD) --quiet

accept: build
	cmake --build $(BUILD) -j $(JOBS) --target accept

clean:
	rm -rf build
