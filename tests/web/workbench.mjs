// Starts the real server with the built page, and a browser to look at it: what every test here and the measuring
// script share.
import {spawn, execFileSync} from "node:child_process";
import {cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {createRequire} from "node:module";
import {tmpdir} from "node:os";
import path from "node:path";
import {fileURLToPath} from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));
export const source = path.resolve(here, "../..");
const web = process.env.TUBEPLAN_WEB ?? path.join(source, "app/web");
const {chromium} = createRequire(path.join(web, "package.json"))("playwright-core");

export const program = process.env.TUBEPLAN ?? path.join(source, "build/tubeplan");
/** The built page as a folder; without one the server shows the page that it was built with. */
export const page = process.env.TUBEPLAN_PAGE ?? "";
const browserPath = process.env.TUBEPLAN_CHROMIUM ?? "/usr/bin/chromium";

/** A folder of its own with the shipped cells, gone at the end. */
export function makeFolder() {
  const folder = mkdtempSync(path.join(tmpdir(), "tubeplan-web-"));
  cpSync(path.join(source, "app/cells"), folder, {recursive: true});
  return {
    folder,
    remove: () => rmSync(folder, {recursive: true, force: true}),
  };
}

/** Practice readings made by the program, as NAME.csv in the folder. */
export function simulate(folder, name, options) {
  const out = path.join(folder, `${name}-made`);
  execFileSync(
    program,
    [
      "simulate",
      path.join(folder, options.cell ?? "bench.yaml"),
      "--design",
      options.design ?? "bench",
      "--readings",
      String(options.readings ?? 120),
      "--seed",
      String(options.seed ?? 7),
      "--spread",
      "0.1",
      ...(options.hide ? ["--hide", options.hide] : []),
      "--out",
      out,
    ],
    {stdio: "pipe"},
  );
  const file = path.join(folder, `${name}.csv`);
  cpSync(path.join(out, "measurements.csv"), file);
  rmSync(out, {recursive: true});
  return file;
}

/** The mock-up with another sheet: a full disc of 15,529 holes. */
export function writeDisc(folder) {
  const text = readFileSync(path.join(folder, "mockup.yaml"), "utf8")
    .replace(/layout: \{[^}]*\}/, "layout: {type: disc, pitch: 0.875, radius: 57.25}")
    .replace(/hole_diameter: .*/, "hole_diameter: 0.635")
    .replace(/leg: hot/, "leg: full")
    .replace(/^name: .*/m, "name: disc-mockup")
    .replace(/calibration_tool:[\s\S]*?(?=scene:)/, "");
  writeFileSync(path.join(folder, "disc.yaml"), text);
  return "disc.yaml";
}

let states = 0;

/** tubeplan serve on a free port, its session kept in `state`; resolves once it has printed its address. */
export async function serve(folder, cell, more = [], state = path.join(folder, `state-${++states}`)) {
  const child = spawn(
    program,
    [
      "serve",
      path.join(folder, cell),
      ...["--port", "0", "--folder", folder, "--state", state],
      ...(page ? ["--page", page] : []),
      ...more,
    ],
    {stdio: ["ignore", "pipe", "pipe"]},
  );
  let said = "";
  const address = await new Promise((resolve, reject) => {
    const listen = (chunk) => {
      said += chunk;
      const found = /https?:\/\/[^\s]+/.exec(said);
      if (found) resolve(found[0]);
    };
    child.stdout.on("data", listen);
    child.stderr.on("data", listen);
    child.on("exit", (code) => reject(new Error(`tubeplan serve ended with ${code}: ${said}`)));
    setTimeout(() => reject(new Error(`tubeplan serve printed no address: ${said}`)), 20000).unref();
  });
  child.removeAllListeners("exit");
  return {
    address,
    /** As when the machine stops: no word to the program. */
    kill: () =>
      new Promise((resolve) => {
        child.on("exit", resolve);
        child.kill("SIGKILL");
      }),
    stop: () =>
      new Promise((resolve) => {
        child.on("exit", resolve);
        child.kill("SIGINT");
        setTimeout(() => child.kill("SIGKILL"), 3000).unref();
      }),
  };
}

export function launch() {
  return chromium.launch({
    executablePath: browserPath,
    args: ["--no-sandbox", "--enable-unsafe-swiftshader"],
  });
}

/** A tab whose console errors are kept: a test ends by asserting that there are none. */
export async function openTab(browser, address, options = {}) {
  const context = await browser.newContext({
    viewport: {width: 1280, height: 720},
    ...options,
  });
  const tab = await context.newPage();
  tab.errors = [];
  tab.on("console", (message) => message.type() === "error" && tab.errors.push(message.text()));
  tab.on("pageerror", (error) => tab.errors.push(error.stack ?? error.message));
  await tab.goto(address);
  return tab;
}
