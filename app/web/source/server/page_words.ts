// Translation of the program's messages from its command line to the page, on which options are fields and buttons.
import type {Problem} from "./documents";

/** Advice that names an option, and its equivalent on the page. */
const ADVICE: readonly (readonly [RegExp, string])[] = [
  [/--(column|units)\b/, "Choose above what each column is, and its unit."],
  [/--(dates|orientation|points|kind)\b/, "Choose it below the tables."],
  [/--sigma\b/, "Enter one standard deviation of a coordinate below the tables."],
  [/--touches\b/, "Touch holes under Calibrate."],
  [/--tubes\b/, "Select holes on the sheet."],
  [/`tubeplan compare/, "Open readings: under Error stands what the error depends on."],
];

const NAMES_A_COMMAND = /--[a-z]|`tubeplan /;

/** Returns the text without what a command or a request offers as an alternative: options and addresses. */
function withoutAlternatives(text: string): string {
  return text
    .replace(/ \([^()]*--[a-z][^()]*\)/g, "")
    .replace(/ \((GET|POST|DELETE) \/[^()]*\)/g, "")
    .replace(/,? or (equally )?--[a-z-]+([ =][^\s,;]+)?/g, "")
    .replace(/[,;] (as )?(`[^`]*--[^`]*`|--[a-z]).*?(?=[,;]|: |$)/g, "");
}

/** Returns the text without such alternatives, and other options and keys of a request by their bare names. */
export function pageWords(text: string): string {
  return withoutAlternatives(text)
    .replace(/^request \(([\w-]+)\)/, "$1")
    .replace(/(^|[^\w-])--(?=[a-z])/g, "$1");
}

/** Returns advice in the page's words. Clauses that name a command and have no equivalent on the page are omitted. */
export function pageAdvice(text: string): string {
  const plain = withoutAlternatives(text);
  const equivalent = ADVICE.find(([option]) => option.test(plain))?.[1];
  if (equivalent !== undefined) return equivalent;
  return plain
    .split("; ")
    .filter((clause) => !NAMES_A_COMMAND.test(clause))
    .join("; ");
}

/** Returns the problem in the page's words; `expected` is empty unless a value is wrong. */
export function pageProblem({where = "", found = "", expected = "", advice = "", message}: Problem): Required<Problem> {
  const [at, had, wanted, said] = [where, found, expected, message].map(pageWords);
  return {where: at, found: had, expected: wanted, message: said, advice: pageAdvice(advice)};
}
