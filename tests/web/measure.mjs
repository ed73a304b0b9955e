// Measures the page's performance: frame rate with 15,529 holes, time to the first picture, slider latency, and size of
// the page. With --pictures DIR it also takes screenshots; with --live SECONDS it sends twenty encoder readings per
// second. It prints the results and asserts nothing, because machines differ.
import {mkdirSync, readdirSync, readFileSync, statSync} from "node:fs";
import path from "node:path";
import {gzipSync} from "node:zlib";
import {callApi, launch, makeFolder, openTab, page as built, serve, simulate, writeDisc} from "./workbench.mjs";

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
const at = (values, share) => [...values].sort((a, b) => a - b)[Math.floor(share * (values.length - 1))];

function weigh() {
  if (!built) return console.log("page weight: TUBEPLAN_PAGE names no folder with the built page");
  const files = readdirSync(built, {recursive: true})
    .map((name) => path.join(built, name))
    .filter((name) => statSync(name).isFile());
  const sizes = files.map((name) => ({
    name: path.relative(built, name),
    bytes: statSync(name).size,
    zipped: gzipSync(readFileSync(name)).length,
  }));
  const total = sizes.reduce((sum, file) => sum + file.bytes, 0),
    zipped = sizes.reduce((sum, file) => sum + file.zipped, 0);
  console.log(
    `page weight: ${(total / 1024).toFixed(0)} KiB in ${files.length} files, ${(zipped / 1024).toFixed(0)} KiB compressed`,
  );
  const first = sizes.filter((file) => !/arm_|plan_|greek/.test(file.name));
  console.log(
    `  before the first 3-D view: ${(first.reduce((sum, file) => sum + file.bytes, 0) / 1024).toFixed(0)} KiB`,
  );
}

/** Measures the time from the request to the first drawing of all holes. */
async function firstPicture(browser, address) {
  const times = [];
  for (let i = 0; i < 3; ++i) {
    const tab = await openTab(browser, "about:blank");
    await tab.addInitScript(() =>
      new PerformanceObserver((list) => {
        window.firstSheet ??= list.getEntries()[0].startTime + list.getEntries()[0].duration;
      }).observe({entryTypes: ["measure"]}),
    );
    await tab.goto(address);
    await tab.waitForFunction(() => window.firstSheet, null, {
      timeout: 20000,
    });
    times.push(await tab.evaluate(() => window.firstSheet));
    await tab.context().close();
  }
  console.log(`load to first picture of 15,529 holes: ${times.map((time) => time.toFixed(0)).join(", ")} ms`);
}

async function framesPerSecond(browser, address) {
  const tab = await openTab(browser, address);
  await tab.waitForSelector(".stage");
  await tab.waitForTimeout(800);
  await tab.evaluate(() => {
    window.draws = [];
    window.ticks = [];
    new PerformanceObserver((list) => list.getEntries().forEach((entry) => window.draws.push(entry.duration))).observe({
      entryTypes: ["measure"],
    });
    const tick = (now) => {
      window.ticks.push(now);
      requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  });
  // The sheet is moved by a script in the page, once per frame, so that messages to the browser are not measured.
  await tab.evaluate(
    () =>
      new Promise((resolve) => {
        const stage = document.querySelector(".stage");
        const box = stage.getBoundingClientRect();
        const start = performance.now();
        const step = () => {
          const t = (performance.now() - start) / 1000;
          stage.dispatchEvent(
            new WheelEvent("wheel", {
              clientX: box.left + box.width / 2,
              clientY: box.top + box.height / 2,
              deltaY: 12 * Math.sin(3 * t),
              bubbles: true,
              cancelable: true,
            }),
          );
          if (t < 3) requestAnimationFrame(step);
          else resolve();
        };
        step();
      }),
  );
  const {ticks, draws} = await tab.evaluate(() => ({
    ticks: window.ticks,
    draws: window.draws,
  }));
  const gaps = ticks.slice(1).map((now, i) => now - ticks[i]);
  console.log(
    `zooming 15,529 holes: ${((1000 * gaps.length) / (ticks.at(-1) - ticks[0])).toFixed(1)} frames/s; ` +
      `drawing takes ${median(draws).toFixed(2)} ms (95 %: ${at(draws, 0.95).toFixed(2)} ms); longest frame ${Math.max(...gaps).toFixed(0)} ms`,
  );
  await tab.context().close();
}

/** Measures the time from a slider's input event until the read-out shows the program's answer. */
async function sliderLatency(browser, address) {
  const tab = await openTab(browser, `${address}#arm`);
  await tab.waitForSelector(".slider input[type=range]");
  await tab.waitForTimeout(2500);
  const run = () =>
    tab.evaluate(async () => {
      const slider = document.querySelectorAll(".slider input[type=range]")[1],
        figure = document.querySelector(".readout .figure b");
      const times = [];
      for (let i = 0; i < 40; ++i) {
        const before = figure.textContent,
          start = performance.now();
        slider.value = String(40 + (i % 20));
        slider.dispatchEvent(new Event("input", {bubbles: true}));
        while (figure.textContent === before && performance.now() - start < 2000)
          await new Promise((resolve) => setTimeout(resolve, 0));
        times.push(performance.now() - start);
        await new Promise((resolve) => requestAnimationFrame(resolve));
      }
      return times;
    });
  const withPicture = await run();
  console.log(
    `slider to read-out: median ${median(withPicture).toFixed(1)} ms, 95 % ${at(withPicture, 0.95).toFixed(1)} ms (with the 3-D picture)`,
  );
  const alone = await tab.evaluate(async () => {
    const times = [];
    for (let i = 0; i < 60; ++i) {
      const start = performance.now();
      await (
        await fetch("/api/pose", {
          method: "POST",
          headers: {"Content-Type": "application/json"},
          body: JSON.stringify({joints: [0, 40 + 0.3 * i, 0, 0]}),
        })
      ).json();
      times.push(performance.now() - start);
    }
    return times;
  });
  console.log(
    `the program's answer to a pose, as the page sees it: median ${median(alone).toFixed(1)} ms, 95 % ${at(alone, 0.95).toFixed(1)} ms`,
  );
  await tab.context().close();
}

async function settled(tab) {
  await tab.waitForTimeout(500);
  await tab.waitForFunction(() => !document.querySelector(".job"), null, {timeout: 120000});
  await tab.waitForTimeout(500);
}

/** Measures the times from a click on *Set aside*, after a lasso in the plot, to the new ladder and comparison. */
async function newLadder(tab, what) {
  const box = await tab.locator(".residual-plot .u-over").boundingBox();
  await tab.mouse.move(box.x + 0.6 * box.width, box.y + 2);
  await tab.mouse.down();
  for (const [x, y] of [
    [0.9, 0.01],
    [0.9, 0.5],
    [0.6, 0.5],
    [0.6, 0.01],
  ])
    await tab.mouse.move(box.x + x * box.width, box.y + y * box.height, {steps: 5});
  await tab.mouse.up();
  const picked = (await tab.innerText(".selection-bar b")).split(" ")[0];
  const before = await tab.innerText(".ladder-rows");
  const start = Date.now();
  await tab.click(".selection-bar >> text=Set aside");
  await tab.waitForFunction(
    (was) => {
      const now = document.querySelector(".ladder-rows")?.innerText;
      return now && now !== was && document.querySelectorAll(".ladder-bars").length >= 2;
    },
    before,
    {timeout: 60000, polling: 20},
  );
  const ladder = Date.now() - start;
  await tab.waitForFunction(() => !document.querySelector(".job"), null, {timeout: 120000, polling: 20});
  console.log(
    `${what}: ${picked} of 10,000 set aside: new ladder after ${ladder} ms, all after ${Date.now() - start} ms`,
  );
}

/**
 * Measures the time from a pointer motion over the plot of 10,000 readings to the page's next frame, and the time from
 * a click to a new ladder.
 */
async function hoverLatency(browser, folder) {
  const file = simulate(folder, "many", {hide: "hysteresis@theta4:0.06deg", readings: 10000});
  const own = await serve(folder, "bench.yaml", [file]);
  const tab = await openTab(browser, `${own.address}#error`);
  await tab.waitForSelector(".residual-plot .u-over", {timeout: 120000});
  await tab.waitForFunction(() => !document.querySelector(".job"), null, {timeout: 120000});
  await tab.waitForTimeout(3000);
  const times = await tab.evaluate(async () => {
    const over = document.querySelector(".residual-plot .u-over"),
      box = over.getBoundingClientRect();
    const taken = [];
    for (let i = 0; i < 200; ++i) {
      const at = {
        clientX: box.left + box.width * ((0.618 * i) % 1),
        clientY: box.top + box.height * (0.3 + 0.4 * ((0.37 * i) % 1)),
      };
      const start = performance.now();
      over.dispatchEvent(new PointerEvent("pointermove", {...at, bubbles: true}));
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
      taken.push(performance.now() - start);
    }
    return taken;
  });
  console.log(
    `pointing at 10,000 readings: median ${median(times).toFixed(1)} ms, 95 % ${at(times, 0.95).toFixed(1)} ms to the next frame`,
  );
  await newLadder(tab, "a loop, no effect in the model");
  await tab.click(".selection-bar >> text=Undo");
  await settled(tab);
  await callApi(own, "add", {causes: ["hysteresis@theta4"]});
  await tab.waitForSelector(".ladder-row >> nth=2", {timeout: 120000});
  await settled(tab);
  await newLadder(tab, "a loop, one effect in the model");
  await tab.context().close();
  await own.stop();
}

/** Measures the delay of the read-out and the growth of memory at twenty encoder readings a second. */
async function liveInput(browser, folder, seconds) {
  const own = await serve(folder, "bench.yaml");
  const tab = await openTab(browser, `${own.address}#arm`);
  await tab.waitForFunction(() => /\d/.test(document.querySelector(".readout .figure b")?.textContent));
  const devtools = await tab.context().newCDPSession(tab);
  const memory = async () => {
    await devtools.send("HeapProfiler.collectGarbage");
    const heap = (await devtools.send("Runtime.getHeapUsage")).usedSize / 1048576;
    const resident = Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${own.pid}/status`, "utf8"))[1]) / 1024;
    return `server ${resident.toFixed(1)} MiB, page ${heap.toFixed(1)} MiB`;
  };
  await tab.evaluate(() => {
    window.shown = [];
    const figure = document.querySelector(".readout .figure b");
    new MutationObserver(() => window.shown.push(Date.now())).observe(figure, {
      characterData: true,
      childList: true,
      subtree: true,
    });
  });
  const sent = [];
  let answered = 0;
  const begin = Date.now();
  for (let k = 0; Date.now() - begin < 1000 * seconds; ++k) {
    const wave = 20 * Math.sin(0.05 * k);
    sent.push(Date.now());
    await callApi(own, "live/encoders", {joints: [10 + wave, 45, -35 - 0.5 * wave, 12], load: 20});
    ++answered;
    if (k === 200 || k % 600 === 599) console.log(`  after ${(k / 20).toFixed(0)} s: ${await memory()}`);
    await new Promise((resolve) => setTimeout(resolve, Math.max(0, begin + 50 * (k + 1) - Date.now())));
  }
  const shown = await tab.evaluate(() => window.shown);
  const behind = sent.map((at, k) => {
    const next = shown.find((time) => time >= at);
    return next === undefined || next >= (sent[k + 1] ?? Infinity) ? null : next - at;
  });
  const known = behind.filter((value) => value !== null);
  console.log(
    `live: ${answered} encoder readings in ${seconds} s, ${shown.length} changes of the read-out ` +
      `(${(shown.length / seconds).toFixed(1)} a second); ${known.length} shown before the next came, ` +
      `median ${median(known)} ms, 95 % ${at(known, 0.95)} ms behind`,
  );
  await tab.context().close();
  await own.stop();
}

async function pictures(browser, folder, into) {
  mkdirSync(into, {recursive: true});
  const shoot = (tab, name) => tab.screenshot({path: path.join(into, `${name}.png`)});
  const {address, stop} = await serve(folder, "mockup.yaml", ["--truth", path.join(folder, "mockup-true.yaml")]);
  const sizes = [
    ["1280x720", 1280, 720, "light"],
    ["1280x720-dark", 1280, 720, "dark"],
    ["1920x1080", 1920, 1080, "light"],
    ["1920x1080-dark", 1920, 1080, "dark"],
    ["1024x768-tablet", 1024, 768, "light"],
  ];
  const tabs = [];
  for (const [name, width, height, colorScheme] of sizes) {
    tabs.push([
      name,
      await openTab(browser, address, {
        viewport: {width, height},
        colorScheme,
        hasTouch: name.includes("tablet"),
      }),
    ]);
  }
  const [, first] = tabs[0];
  await first.waitForSelector(".stage");
  await first.click(".rail-entry >> text=Calibrate");
  await first.click(".calibrate-view >> text=Suggest");
  for (let k = 1; k <= 3; ++k) {
    await first.click(".touch-row:not(.done) >> text=Simulate >> nth=0", {
      timeout: 60000,
    });
    await first.waitForFunction((n) => document.querySelectorAll(".touch-row.done").length === n, k);
  }
  await first.click(".touch-list > .button.first");
  await first.waitForSelector(".calibrate-view h3", {timeout: 60000});
  await first.waitForSelector(".calibrate-view .stage-foot .mark", {
    timeout: 60000,
  });
  await first.click(".rail-entry >> text=Sheet");
  await first.fill(".select-box input", "spread:60");
  await first.click(".select-box button[type=submit]");
  await first.waitForSelector("text=60 holes");
  await first.click(".rail-entry >> text=Plan");
  await first.click(".plan-head .button.first");
  await first.waitForSelector(".tube-rows .tube-row", {timeout: 120000});
  for (const view of ["sheet", "arm", "plan", "calibrate"]) {
    for (const [name, tab] of tabs) {
      await tab.bringToFront();
      await tab.evaluate((hash) => (location.hash = hash), view);
      await tab.waitForTimeout(1200);
      await tab.waitForFunction(
        () =>
          [...document.querySelectorAll(".arm-picture canvas")].every(
            (canvas) => canvas.width >= canvas.clientWidth - 1,
          ),
        null,
        {timeout: 10000},
      ); // until the picture is drawn at full resolution
      await tab.waitForTimeout(800);
      await shoot(tab, `${view}-${name}`);
    }
  }
  for (const [, tab] of tabs) await tab.context().close();
  await stop();
  const bench = await serve(folder, "bench.yaml", [path.join(folder, "readings.csv")]);
  const errorTabs = [];
  for (const [name, width, height, colorScheme] of sizes) {
    errorTabs.push([
      name,
      await openTab(browser, `${bench.address}#error`, {
        viewport: {width, height},
        colorScheme,
      }),
    ]);
  }
  const [, lead] = errorTabs[0];
  const all = async (step) => {
    for (const [name, tab] of errorTabs) {
      await tab.bringToFront();
      await tab.waitForTimeout(1300);
      await shoot(tab, `error-${step}-${name}`);
    }
  };
  await lead.waitForSelector(".next:has-text('Diagnose'):not([disabled])", {
    timeout: 60000,
  });
  await all("1-compared");
  await lead.click(".next");
  await lead.waitForSelector(".next:has-text('Add'):not([disabled])", {
    timeout: 60000,
  });
  await all("2-diagnosed");
  await lead.click(".next");
  await lead.waitForSelector(".verdict h1 >> text=At the noise floor", {
    timeout: 60000,
  });
  await all("3-added");
  await bench.stop();
}

const {folder, remove} = makeFolder();
const browser = await launch();
try {
  weigh();
  const server = await serve(folder, writeDisc(folder));
  await firstPicture(browser, server.address);
  await framesPerSecond(browser, server.address);
  await server.stop();
  const mockup = await serve(folder, "mockup.yaml");
  await sliderLatency(browser, mockup.address);
  await mockup.stop();
  await hoverLatency(browser, folder);
  if (process.argv.includes("--live"))
    await liveInput(browser, folder, Number(process.argv[process.argv.indexOf("--live") + 1]));
  const into = process.argv[process.argv.indexOf("--pictures") + 1];
  if (process.argv.includes("--pictures")) {
    simulate(folder, "readings", {hide: "hysteresis@theta4:0.06deg"});
    await pictures(browser, folder, into);
  }
} finally {
  await browser.close();
  remove();
}
