// Tests of the outage page: marking a planned tube by keyboard, rejecting a wrong tube, one record open in two browsers
// and the command line, and a complete shift on the server.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {after, before, describe} from "node:test";
import {rmSync, writeFileSync} from "node:fs";
import path from "node:path";
import {it} from "./limits.mjs";
import {begin, callApi, closable, errorsOf, finish, openTab, program, serve} from "./workbench.mjs";

const LIMIT = {timeout: 60_000};
let made, browser;

before(async () => ({made, browser} = await begin()));
after(() => finish({made, browser}));

const job = (...words) =>
  JSON.parse(
    execFileSync(program, ["job", ...words, "--json", "-"], {cwd: made.folder, stdio: ["ignore", "pipe", "pipe"]}),
  );

/** Makes the record NAME.job of a small job; `confirm` is how its tubes are confirmed. */
function makeRecord(name, confirm, tubes = "R9-11C18-22") {
  writeFileSync(
    path.join(made.folder, `${name}.yaml`),
    `job: ${name}\nunits: {length: in, angle: deg, force: lbf}\n` +
      "steam_generators: [{name: A, hot: mockup.yaml, cold: mirrored}]\ntools: [{name: bobbin}]\n" +
      `packages: [{name: rows, tubes: ${tubes}, tool: bobbin, confirm: ${confirm}}]\n`,
  );
  job("create", `${name}.yaml`, "--out", `${name}.job`);
  return `${name}.job`;
}

/** Opens the outage page at a record, with the name of the person who marks the tubes. */
async function desk(server, record, person) {
  const tab = await openTab(browser, `${server.address}#outage`);
  await tab.waitForSelector(".desk-tube", LIMIT);
  await tab.selectOption("select[aria-label='Record of the job']", record);
  await tab.fill(".desk-bar input", person);
  return tab;
}

const shown = (tab) => tab.getAttribute(".desk-tube", "data-tube", LIMIT);

describe("the desk of an outage", () => {
  it("lets no tool in before another person has read the right tube", async () => {
    const record = makeRecord("read", "read-back");
    const server = await serve(made.folder, "mockup.yaml");
    const tab = await desk(server, record, "Tom");
    const {close} = closable(tab, server);
    await tab.waitForSelector(".desk-tube[data-tube='A/hot/R9C18']", LIMIT);
    assert.equal(await tab.isDisabled(".desk-marks button:has-text('done')"), true);
    await tab.fill(".desk-confirm input[name=by]", "Maria");
    await tab.fill(".desk-confirm input[name=read]", "A/hot/R10C18");
    await tab.click(".desk-confirm button");
    await tab.waitForSelector(".desk-found.bad >> text=1 row off", LIMIT);
    await tab.waitForSelector(".desk-warning >> text=R10C18", LIMIT);
    assert.equal(await tab.isDisabled(".desk-marks button:has-text('done')"), true);
    await tab.fill(".desk-confirm input[name=read]", "A/hot/R9C18");
    await tab.click(".desk-confirm button");
    await tab.waitForSelector(".desk-found.good", LIMIT);
    await tab.click(".desk-tube"); // moves the focus out of the input field, where keys would be typed text
    await tab.keyboard.press("d");
    await tab.waitForSelector(".desk-tube[data-tube='A/hot/R9C19']", LIMIT);
    const [entry] = job("log", record).events.filter(({kind}) => kind === "mark");
    assert.deepEqual([entry.tube, entry.value, entry.who], ["A/hot/R9C18", "done", "Tom"]);
    assert.equal(errorsOf(tab).length, 0);
    await close();
  });

  it("loses no mark of two browsers and a command line at once", async () => {
    const record = makeRecord("many", "none");
    const server = await serve(made.folder, "mockup.yaml");
    const tabs = [await desk(server, record, "Tom"), await desk(server, record, "Maria")];
    const {close} = closable(tabs[0], server);
    await tabs[0].selectOption("select[aria-label='Leg']", "A/hot");
    await tabs[1].selectOption("select[aria-label='Leg']", "A/cold");
    await tabs[0].waitForSelector(".desk-tube[data-tube^='A/hot']", LIMIT);
    await tabs[1].waitForSelector(".desk-tube[data-tube^='A/cold']", LIMIT);
    const marked = new Set();
    for (let k = 0; k < 5; ++k) {
      for (const tab of tabs) {
        const tube = await shown(tab);
        await tab.click(".desk-marks button:has-text('done')");
        await tab.waitForSelector(`.desk-tube:not([data-tube='${tube}'])`, LIMIT);
        marked.add(tube);
      }
      const tube = `A/hot/R11C${18 + k}`;
      job("mark", record, tube, "--as", "obstructed", "--by", "Paul");
      marked.add(tube);
    }
    const log = job("log", record).events;
    assert.equal(log.length, 15);
    assert.deepEqual(new Set(log.map(({tube}) => tube)), marked);
    await tabs[1].close();
    await close();
  });

  it("asks for what is new alone, and shows what another desk has done and the plan", async () => {
    const record = makeRecord("news", "none");
    job("mark", record, "A/hot/R9C18", "--as", "done", "--by", "Paul");
    const server = await serve(made.folder, "mockup.yaml");
    const tab = await desk(server, record, "Tom");
    const {close} = closable(tab, server);
    await tab.waitForSelector(".desk-tube[data-tube='A/hot/R9C19']", LIMIT);
    const requested = [];
    tab.on("request", (request) => requested.push(new URL(request.url())));
    await tab.waitForRequest((request) => request.url().includes("after=1"), LIMIT);
    await tab.waitForTimeout(500);
    const own = requested.filter(({pathname}) => pathname.startsWith("/api/outage/"));
    assert.deepEqual([...new Set(own.map(({pathname}) => pathname))], ["/api/outage/log"]);
    job("undo", record, "--event", "1", "--by", "Paul", "--reason", "extent too short");
    await tab.waitForSelector(".desk-event.undone >> text=A/hot/R9C18", LIMIT);
    assert.equal(await tab.locator(".desk-event").count(), 2);
    assert.equal(await tab.locator(".desk-plan").count(), 0);
    job("plan", record, "--out", "news-plans");
    await tab.waitForSelector(".desk-plan .gantt svg", LIMIT);
    const address = await tab.getAttribute(".desk-bar a[download]", "href");
    const report = await fetch(new URL(address, server.address));
    assert.equal(report.status, 200);
    assert.match(report.headers.get("content-disposition"), /handover\.html/);
    assert.match(await report.text(), /"page":"hand-over"/);
    const unknown = await callApi(server, `outage/report?file=${record}&shift=nigth`);
    assert.equal(unknown.status, 422);
    assert.equal((await callApi(server, `outage/log?file=${record}&after=-3`)).status, 422);
    assert.equal(errorsOf(tab).length, 0);
    await close();
  });

  it("leaves a record that cannot be read, and takes no leg of it along", async () => {
    const broken = path.join(made.folder, "0.job");
    const record = makeRecord("whole", "none");
    writeFileSync(broken, "event,at,who\n");
    const server = await serve(made.folder, "mockup.yaml");
    const tab = await openTab(browser, `${server.address}#outage`);
    const choice = "select[aria-label='Record of the job']";
    await tab.waitForSelector(choice, LIMIT);
    assert.equal(await tab.inputValue(choice), "0.job");
    await tab.selectOption(choice, record);
    await tab.waitForSelector(".desk-tube[data-tube='A/hot/R9C18']", LIMIT);
    await tab.selectOption("select[aria-label='Leg']", "A/cold");
    await tab.waitForSelector(".desk-tube[data-tube^='A/cold']", LIMIT);
    await tab.selectOption(choice, "0.job");
    await tab.waitForSelector(".desk-tube", {state: "detached", ...LIMIT}); // no key marks a tube of the other record
    await tab.selectOption(choice, record);
    await tab.waitForSelector(".desk-tube[data-tube='A/hot/R9C18']", LIMIT);
    rmSync(broken);
    await tab.context().close();
    await server.stop();
  });

  it("refuses a mark of a tube that another desk has changed", async () => {
    const record = makeRecord("late", "none");
    const server = await serve(made.folder, "mockup.yaml");
    const next = (await callApi(server, `outage/next?file=${record}`)).body;
    job("mark", record, next.tube, "--as", "obstructed", "--by", "Paul");
    const late = await callApi(server, "outage/mark", {
      file: record,
      tube: next.tube,
      as: "done",
      by: "Tom",
      after: next.last_event,
    });
    assert.equal(late.status, 422);
    assert.equal(job("log", record).events.length, 1);
    await server.stop();
  });

  it("works a shift of 60 tubes through the server, with an arm that stands under a wrong hole now and then", async () => {
    const record = makeRecord("shift", "position", "R9-14C20-29");
    const server = await serve(made.folder, "mockup.yaml");
    const PITCH = 1.0625;
    let wrong = 0,
      random = 7;
    const draw = () => (random = (random * 16807) % 2147483647) / 2147483647;
    for (let k = 0; k < 60; ++k) {
      const {body: tube} = await callApi(server, `outage/next?file=${record}&sg=A&leg=hot`);
      const at = {x: tube.x + 0.04 * (draw() - 0.5), y: tube.y + 0.04 * (draw() - 0.5)};
      const where = {file: record, tube: tube.tube};
      if (k % 10 === 3) {
        const under = await callApi(server, "outage/confirm", {...where, by: "camera", position: [at.x + PITCH, at.y]});
        assert.equal(under.body.same, false);
        assert.equal((await callApi(server, "outage/mark", {...where, as: "done", by: "Tom"})).status, 422);
        ++wrong;
      }
      const found = await callApi(server, "outage/confirm", {...where, by: "camera", position: [at.x, at.y]});
      assert.equal(found.body.same, true);
      assert.equal(
        (await callApi(server, "outage/mark", {...where, as: k % 7 === 5 ? "retest" : "done", by: "Tom"})).status,
        200,
      );
    }
    const {total} = (await callApi(server, `outage/totals?file=${record}`)).body;
    assert.equal(total.planned, total.done + total.excluded + total.unresolved);
    assert.equal(total.done + total.queued, 60);
    const events = (await callApi(server, `outage/log?file=${record}`)).body.events;
    assert.equal(events.length, 60 + 60 + wrong);
    await server.stop();
  });
});
