// What the program says to its command line, said on the page: its options are fields and buttons here.
import type {Problem} from "./documents";

/** Advice that names an option, and what does the same here; with nothing that does, it is of no use here. */
const ADVICE: readonly (readonly [RegExp, string])[] = [
  [/--(column|units)\b/, "Choose above what each column is, and its unit."],
  [/--(dates|orientation|points|kind)\b/, "Choose it below the tables."],
  [/--sigma\b/, "Enter one standard deviation of a coordinate below the tables."],
  [/--touches\b/, "Touch holes under Calibrate."],
  [/--tubes\b/, "Select holes on the sheet."],
  [/`tubeplan compare/, "Open readings: under Error stands what the error depends on."],
  [/--[a-z]|`tubeplan /, ""],
];

/** Without the options that it offers beside something else. */
export function pageWords(text: string): string {
  return text
    .replace(/ \(--[^)]*\)/g, "")
    .replace(/,? or (equally )?--[a-z-]+([ =][^\s,;]+)?/g, "")
    .replace(/^--(?=[a-z])/, "");
}

export function pageAdvice(text: string): string {
  const plain = pageWords(text);
  return ADVICE.find(([option]) => option.test(plain))?.[1] ?? plain;
}

export function pageProblem({where = "", found = "", expected = "", advice = "", message}: Problem): Required<Problem> {
  const [at, had, wanted, said] = [where, found, expected, message].map(pageWords);
  return {where: at, found: had, expected: wanted, message: said, advice: pageAdvice(advice)};
}
