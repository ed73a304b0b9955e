// Tests of the modules that reports and workbench share: shapes, arrows, frames, and texts.
import {readdirSync, readFileSync} from "node:fs";
import path from "node:path";
import {describe, expect, it} from "vitest";
import {arrowCorners, usualLargest} from "../../drawing/arrows.js";
import {conditionsOf, pairCells, separations, senseArrow} from "../../drawing/conditions.js";
import {
  effectTitle,
  explanationsOf,
  explanationTitle,
  explanationWords,
  keptText,
  sizeText,
  withIt,
} from "../../drawing/explanations.js";
import {extentOf, fit, fromPixel, nearestPlace, toPixel} from "../../drawing/frames.js";
import {stateMark, verdictMark} from "../../drawing/kinds.js";
import {inPlane, PLANES} from "../../drawing/planes.js";
import {rankingRows, triedText} from "../../drawing/ranking.js";
import {hollowPath, outlineOf, type Shape} from "../../drawing/shapes.js";
import {isInShare, shareText} from "../../drawing/shares.js";
import {READING_SIGMAS, sigmasText} from "../../drawing/sigma_text.js";
import {verdictItems} from "../../drawing/verdict_items.js";
import {requiredText, visitText} from "../../drawing/visits.js";

const SHAPES: Shape[] = [
  "ring",
  "double-ring",
  "target",
  "dot",
  "disc",
  "half",
  "square",
  "diamond",
  "triangle",
  "cross",
  "bar",
  "hatched",
  "plus",
  "hollow-triangle",
  "hollow-square",
  "crossed-ring",
];

describe("shapes", () => {
  it("are each something of their own, filled or a line with a width", () => {
    const drawn = SHAPES.map((shape) => outlineOf(shape, 0, 0, 10));
    for (const {fill, line, width} of drawn) {
      expect(fill + line).toMatch(/^M/);
      expect(line !== "").toBe(width > 0);
    }
    expect(new Set(drawn.map(({fill, line}) => `${fill}|${line}`)).size).toBe(SHAPES.length);
    expect(outlineOf("none", 0, 0, 10)).toEqual({fill: "", line: "", width: 0});
  });
  it("can be drawn hollow", () => {
    expect(hollowPath("disc", 5, 5, 2)).toBe(outlineOf("disc", 5, 5, 2).fill);
  });
  it("tell kinds apart without colour", () => {
    expect(stateMark("no such state").shape).toBe("diamond");
    expect(verdictMark("constructor").shape).toBe("diamond");
  });
});

describe("arrows", () => {
  it("have a head that ends them and never exceeds them", () => {
    const [nx, ny, ax, ay, bx, by] = arrowCorners(0, 0, 100, 0, 6)!;
    expect([nx, ny]).toEqual([94, 0]);
    expect([ax, bx]).toEqual([94, 94]);
    expect(ay).toBeCloseTo(-by);
    expect(arrowCorners(0, 0, 2, 0, 6)![0]).toBeCloseTo(0.4);
  });
  it("are nothing where they are too short to be seen", () => {
    expect(arrowCorners(3, 4, 0.3, 0.3)).toBeNull();
    expect(arrowCorners(3, 4, 0, 0)).toBeNull();
    expect(arrowCorners(0, 0, 20, 0)!.map((value) => Number(value.toFixed(1)))).toEqual([14, 0, 14, 2.5, 14, -2.5]);
  });
  it("are scaled by what few errors are beyond", () => {
    const sizes = Array.from({length: 100}, (_, k) => k + 1);
    expect(usualLargest([...sizes, 1e6])).toBe(99);
    expect(usualLargest([null, undefined, NaN])).toBe(0);
  });
});

describe("frames", () => {
  const margin = {left: 10, right: 30, top: 20, bottom: 40},
    size = {width: 400, height: 300};
  it("show an extent within its margins, and back", () => {
    const camera = fit({left: 0, right: 36, bottom: 0, top: 24}, size, margin);
    expect(toPixel(camera, size, 0, 0)).toEqual([10, 260]);
    expect(toPixel(camera, size, 36, 24)).toEqual([370, 20]);
    expect(fromPixel(camera, size, 190, 140)).toEqual([18, 12]);
  });
  it("know extents and the place that is pointed at", () => {
    const places = [[1, 2], [5, -3], null] as [number, number][];
    expect(extentOf(places.slice(0, 2))).toEqual({left: 1, right: 5, bottom: -3, top: 2});
    expect(nearestPlace(places, 4, -3, 2)).toBe(1);
    expect(nearestPlace(places, 20, 20, 2)).toBe(-1);
    expect(inPlane(PLANES[1], [1, 2, 3])).toEqual([1, 3]);
  });
});

const slack = {effect: "slack", at: "wrist.z", words: "a clearance", parameters: {half_gap: {value: 0.1, sigma: 0.01}}};

describe("explanations", () => {
  it("are named by their effects, with the numbers that say something", () => {
    expect(effectTitle(slack)).toBe("slack at wrist.z");
    expect(explanationTitle({effects: [slack, {effect: "drift", at: "base"}]})).toBe(
      "slack at wrist.z and drift at base",
    );
    expect(sizeText(slack)).toBe("half gap 0.100 ± 0.010");
    expect(sizeText({...slack, parameters: {a: {value: 0}, b: {value: 2, unit: "in"}, c: "text", d: null}})).toBe(
      "b 2.00\u00a0in",
    );
  });
  it("say what they are in the words of the document, each once", () => {
    expect(explanationWords({effects: [slack, slack]})).toBe("a clearance");
    expect(explanationWords({effects: [slack], enough: false})).toMatch(/not enough/);
    expect(withIt({effects: [slack], enough: false})).toBe("with the closest, slack at wrist.z");
  });
  it("are all there: those with figures first", () => {
    const other = {effect: "drift", at: "base"};
    const found = explanationsOf({explanations: [{effects: [slack]}], alternatives: [[slack], [other]]});
    expect(found.map(explanationTitle)).toEqual(["slack at wrist.z", "drift at base"]);
    expect(explanationsOf({})).toEqual([]);
  });
  it("say how much shows", () => {
    expect(keptText(0.03)).toMatch(/^3\.0\u00a0% of it is observable/);
    expect(keptText(0.99)).toBe("all of it is observable");
    expect(keptText(null)).toBe("");
  });
});

describe("the ranking", () => {
  const rows = rankingRows([
    {
      ...slack,
      probability: 0.9,
      chi2_fall: 200,
      kept_fraction: 0.4,
      size: {name: "half_gap", value: 1, sigma: 0.1, unit: "1"},
    },
    {effect: "drift", at: "base", probability: null, chi2_fall: 50, kept_fraction: null, size: null},
  ]);
  it("has figures with shares for bars", () => {
    expect(rows.map(({fall}) => fall)).toEqual([
      {share: 1, text: "200"},
      {share: 0.25, text: "50.0"},
    ]);
    expect(rows[0].size).toEqual({name: "half gap", text: "1.00 ± 0.10"});
    expect(rows[1].probability).toEqual({share: 0, text: "–"});
    expect(rows[1].words).toBe("");
  });
  it("says how many were tried", () => {
    expect(triedText({ranking: rows, probability: {nothing_missing: 0.2, unknown_alone: 0}})).toMatch(
      /^2 causes were tried.*20\.0/,
    );
    expect(triedText({ranking: [1]})).toMatch(/^1 cause was tried/);
  });
});

describe("readings", () => {
  it("say their conditions, with what is not there left out", () => {
    const rows = conditionsOf(
      {joints: [-53.126, 75.7], senses: [1, 0], load: 20},
      [{name: "a", unit: "deg"}, {name: "b"}],
      {
        force: "lbf",
      },
    );
    expect(rows.map(({name, figure, unit, sense}) => `${name} ${figure} ${unit} ${sense}`.trim())).toEqual([
      "a −53.13 deg ↑",
      "b 75.70",
      "load 20 lbf",
    ]);
    expect(senseArrow(-1)).toBe("↓");
    expect(senseArrow(undefined)).toBe("");
  });
  it("tell explanations apart by so much", () => {
    expect(
      separations([{separation_sigmas: 8}, {separation_sigmas: null}]).map(({share, text}) => [share, text]),
    ).toEqual([
      [1, "8.00"],
      [0, "–"],
    ]);
    expect(pairCells({if_true: "A", against: "B", probability_distinguished: 1})).toEqual([
      "A",
      "B",
      "–",
      "–",
      "100.0\u00a0%",
    ]);
  });
  it("are marked from many sigmas on, by a sign too", () => {
    expect(sigmasText(5.04, READING_SIGMAS)).toEqual({text: "▲ 5.0", isMany: true});
    expect(sigmasText(4.96, READING_SIGMAS)).toEqual({text: "5.0", isMany: false});
    expect(sigmasText(undefined, READING_SIGMAS).text).toBe("–");
  });
});

describe("verdicts", () => {
  it("are the sentences of the document, with the advice on further readings last", () => {
    const sentences = ["Missing: slack at wrist.z.", "With it the held-out error falls."];
    expect(verdictItems({sentence: sentences.join(" "), sentences})).toEqual(sentences);
    expect(verdictItems({sentences, splitting: {advice: "Read these next."}})).toEqual([
      ...sentences,
      "Read these next.",
    ]);
  });
  it("say that an effect probably acts at all joints, of which only some are named", () => {
    const sentences = ["Missing: sag."];
    const at = (place: string, chance?: number) => ({effect: "sag", at: place, probability: chance});
    const document = (named: string[], chance: number) => ({
      ...{sentences, joints: ["a", "b", "c"], ranking: [at("all joints", chance), at("a", 0.1)]},
      explanations: [{effects: named.map((place) => at(place))}],
    });
    expect(verdictItems(document(["a", "c"], 0.895)).slice(sentences.length)).toEqual([
      "sag at all joints has the probability 89.5\u00a0%; only at a, c do the readings show its size.",
    ]);
    for (const other of [document(["a", "c"], 0.4), document(["a", "b", "c"], 0.9), document(["all joints"], 0.9)])
      expect(verdictItems(other)).toEqual(sentences);
  });
  it("of an earlier program are its one text, which has the advice", () => {
    const sentence = "No verdict is possible: too few. Read these next.";
    expect(verdictItems({sentence, splitting: {advice: "Read these next."}})).toEqual([sentence]);
    expect(verdictItems({})).toEqual([]);
  });
});

describe("a plan", () => {
  it("says its visits and what it keeps clear", () => {
    expect(visitText(6, 60)).toBe("visit 7 of 60");
    expect(requiredText(0.25, "in")).toBe("required 0.25 in");
  });
});

describe("the files of app/drawing", () => {
  const folder = path.resolve(__dirname, "../../drawing");
  const files = readdirSync(folder).filter((name) => name.endsWith(".js"));
  it("are what reports can carry: ASCII, with imports of one form", () => {
    expect(files.length).toBeGreaterThan(10);
    for (const name of files) {
      const text = readFileSync(path.join(folder, name), "utf8");
      expect(text, name).toMatch(/^[\t\n\r -~]*$/);
      for (const line of text.match(/^(import|export)\b.*/gm) ?? [])
        expect(line, name).toMatch(
          /^(import \{[^}]*\} from "\.\/\w+\.js";|import \{$|export (async )?(function\*?|const|let|class) )/,
        );
    }
  });
});

describe("the share of readings that is drawn", () => {
  const drawn = (count: number, most: number) => [...Array(count).keys()].filter((i) => isInShare(i, count, most));

  it("is all of few, and near what was asked for of many", () => {
    expect(drawn(400, 400)).toHaveLength(400);
    expect(shareText(400, 400)).toBe("");
    for (const count of [401, 1000, 30000]) expect(Math.abs(drawn(count, 400).length - 400)).toBeLessThan(4);
    expect(shareText(30000, 400)).toBe(`${drawn(30000, 400).length} of 30,000 readings drawn`);
  });

  it("has every part of a design that repeats itself, and of the session, as often", () => {
    const indices = drawn(30000, 1500);
    for (const period of [2, 3, 4, 5, 20])
      for (let part = 0; part < period; ++part) {
        const share = indices.filter((i) => i % period === part).length / indices.length;
        expect(Math.abs(share * period - 1)).toBeLessThan(0.1);
      }
    for (let tenth = 0; tenth < 10; ++tenth)
      expect(Math.abs(indices.filter((i) => Math.floor(i / 3000) === tenth).length - 150)).toBeLessThan(4);
  });
});
