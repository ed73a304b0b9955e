// Tests that the test files themselves end within seconds and with a message if the program or the browser fails or
// does not start.
import assert from "node:assert/strict";
import {after, before, describe} from "node:test";
import {spawn} from "node:child_process";
import {chmodSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import path from "node:path";
import {fileURLToPath} from "node:url";
import {it} from "./limits.mjs";

const here = path.dirname(fileURLToPath(import.meta.url));
let folder;

before(() => (folder = mkdtempSync(path.join(tmpdir(), "tubeplan-limits-"))));
after(() => rmSync(folder, {recursive: true, force: true}));

function write(name, text) {
  const file = path.join(folder, name);
  writeFileSync(file, text);
  chmodSync(file, 0o755);
  return file;
}

/** Runs a test file with a dummy program in place of tubeplan or the browser. */
function runTests(name, body, environment) {
  const file = write(
    `${name}.test.mjs`,
    `import {it} from "${here}/limits.mjs";
     import {launch, serve} from "${here}/workbench.mjs";
     ${body}`,
  );
  const env = {...process.env, ...environment};
  delete env.NODE_TEST_CONTEXT; // makes it a separate test run, not a subtest of the current run
  return new Promise((resolve) => {
    const start = Date.now();
    const child = spawn(process.execPath, ["--test", file], {env});
    let said = "";
    for (const stream of [child.stdout, child.stderr]) stream.on("data", (chunk) => (said += chunk));
    const late = setTimeout(() => child.kill("SIGKILL"), 30000);
    child.on("exit", (code) => {
      clearTimeout(late);
      resolve({code, said, seconds: (Date.now() - start) / 1000});
    });
  });
}

/** Returns true if a process runs; a zombie, which has ended, does not count. */
function isRunning(pid) {
  const file = `/proc/${pid}/stat`;
  return existsSync(file) && !/\) [ZX] /.test(readFileSync(file, "utf8"));
}

describe("a file of tests", () => {
  it("ends when a test fails while its server runs, and the server with it", async () => {
    const TUBEPLAN = write("server", `#!/bin/sh\necho $$ > ${folder}/pid\necho http://127.0.0.1:1/\nexec sleep 600\n`);
    const {code, said, seconds} = await runTests(
      "fails",
      `it("fails", async () => { await serve("${folder}", "any.yaml"); throw new Error("meant to fail"); });`,
      {TUBEPLAN},
    );
    assert.notEqual(code, 0);
    assert.ok(seconds < 15, `${seconds} s`);
    assert.match(said, /meant to fail/);
    assert.ok(!isRunning(readFileSync(path.join(folder, "pid"), "utf8").trim()), "its server still runs");
  });

  it("says which program printed no address", async () => {
    const TUBEPLAN = write("silent", "#!/bin/sh\necho reading the cell >&2\nexec sleep 600\n");
    const {code, said, seconds} = await runTests(
      "silent",
      `it("waits", () => serve("${folder}", "any.yaml", [], "${folder}/state", 1000));`,
      {TUBEPLAN},
    );
    assert.notEqual(code, 0);
    assert.ok(seconds < 15, `${seconds} s`);
    assert.match(said, /printed no address within 1 s: reading the cell/);
  });

  it("says that a server ended by itself", async () => {
    const TUBEPLAN = write("dies", "#!/bin/sh\necho http://127.0.0.1:1/\necho out of luck >&2\nexit 3\n");
    const {code, said} = await runTests(
      "dies",
      `it("dies", async () => {
         const server = await serve("${folder}", "any.yaml");
         await new Promise((resolve) => setTimeout(resolve, 500));
         await server.stop();
       });`,
      {TUBEPLAN},
    );
    assert.notEqual(code, 0);
    assert.match(said, /had ended with 3: .*[\s\S]*out of luck/);
  });

  it("says that the browser does not start", async () => {
    const TUBEPLAN_CHROMIUM = write("browser", "#!/bin/sh\nexec sleep 600\n");
    const {code, said, seconds} = await runTests("browser", `it("starts", () => launch(1500));`, {TUBEPLAN_CHROMIUM});
    assert.notEqual(code, 0);
    assert.ok(seconds < 25, `${seconds} s`);
    assert.match(said, /did not start within 1\.5 s/);
  });
});
