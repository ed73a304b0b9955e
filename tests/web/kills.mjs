// Kills the program at random instants of its work, as in a power cut, and starts it again. Every change that the
// program had confirmed must be present, and a saved project must be complete. `node tests/web/kills.mjs [KILLS]
// [SEED]`; exits with 1 if anything is lost.
import {spawnSync} from "node:child_process";
import {existsSync} from "node:fs";
import path from "node:path";
import {callApi, makeFolder, program, serve, simulate, stateOf} from "./workbench.mjs";

const kills = Number(process.argv[2] ?? 50);
let seed = Number(process.argv[3] ?? 1);

/** Returns the next number of Park and Miller's generator, so that a seed reproduces the instants of the kills. */
function random() {
  seed = (48271 * seed) % 2147483647;
  return seed / 2147483647;
}

const below = (count) => Math.floor(random() * count);
const made = makeFolder();
const readings = simulate(made.folder, "readings", {hide: "hysteresis@theta4:0.06deg", seed: 7, readings: 60});
const kept = path.join(made.folder, "kept"),
  project = path.join(made.folder, "mine.tubeplan");
const marks = {aside: new Map(), held_out: new Map()};
let lost = 0,
  orders = 0,
  saves = 0;

const numberOf = (name) => [...marks[name].values()].filter(Boolean).length;

/** Sends one request. Once answered, its change must persist; without an answer, the change may have been made. */
async function work(server) {
  ++orders;
  const kind = below(6);
  if (kind === 0) {
    await callApi(server, "project/save", {file: "mine", overwrite: true});
    ++saves;
  } else if (kind === 1) {
    await callApi(server, "compare", {});
  } else {
    const [route, word] = kind < 4 ? ["set-aside", "aside"] : ["hold-out", "held_out"];
    const id = String(1 + below(50));
    const on = !marks[word].get(id);
    const {status} = await callApi(server, `measurements/${route}`, {ids: [id], [word]: on});
    if (status === 200) marks[word].set(id, on);
  }
}

/** Works until the program is killed. */
async function workUntil(server, instant) {
  let isKilled = false;
  const killed = new Promise((resolve) =>
    setTimeout(() => {
      isKilled = true;
      server.kill().then(resolve);
    }, instant),
  );
  while (!isKilled)
    try {
      await work(server);
    } catch {
      break; // the kill interrupted this answer
    }
  await killed;
}

function complain(words) {
  ++lost;
  console.log(`  LOST: ${words}`);
}

for (let kill = 1; kill <= kills; ++kill) {
  const server = await serve(made.folder, "bench.yaml", kill === 1 ? [readings] : [], kept);
  const found = (await stateOf(server)).measurements;
  if (!found) complain("the readings");
  else
    for (const [word, count] of [
      ["aside", found.set_aside],
      ["held_out", found.held_out],
    ])
      if (Math.abs(count - numberOf(word)) > 1) complain(`${word}: ${count}, answered ${numberOf(word)}`);
  if (found) {
    // The interrupted request may have taken effect, so the program's state is the new reference.
    const all = (await callApi(server, "measurements")).body;
    for (const [word, name] of [
      ["aside", "set_aside"],
      ["held_out", "held_out"],
    ])
      marks[word] = new Map(all.rows.filter((reading) => reading[name] === true).map(({id}) => [id, true]));
  }
  if (existsSync(project)) {
    const read = spawnSync(program, ["report", project, "--out", path.join(made.folder, "report.html")]);
    if (read.status !== 0) complain(`the project: ${read.stderr}`);
  }
  await workUntil(server, 20 + 780 * random());
}
console.log(`${kills} kills in ${orders} orders and ${saves} saves: ${lost} lost`);
made.remove();
process.exit(lost === 0 ? 0 : 1);
