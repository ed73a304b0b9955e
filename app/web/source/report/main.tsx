// Starts a report. The document is in the file, which makes no network requests.
import "./sharp";
import "uplot/dist/uPlot.min.css";
import "../../../drawing/colours.css";
import "../style/tokens.css";
import "../style/views.css";
import "./report.css";
import {render} from "preact";
import {followColours} from "../drawing/colours";
import {campaignPage} from "./campaign/campaign_pages";
import {ERROR_PAGES} from "./errors/error_pages";
import {HAND_OVER_PAGE} from "./outage/hand_over_page";
import {JOB_PLAN_PAGE} from "./outage/job_plan_page";
import {type PageKind, ReportPage} from "./page";
import {PLAN_PAGE} from "./plan/plan_page";
import {object, textOf} from "./values";

const report = object(JSON.parse(document.getElementById("report")!.textContent!)) ?? {};
const PAGES: Record<string, PageKind> = {
  ...ERROR_PAGES,
  plan: PLAN_PAGE,
  campaign: campaignPage(report),
  "hand-over": HAND_OVER_PAGE,
  "job-plan": JOB_PLAN_PAGE,
};
const kind = Object.hasOwn(PAGES, report.page) ? PAGES[report.page] : PAGES.diagnosis;
document.title = textOf(report.title, kind.title);
followColours("light");
render(<ReportPage kind={kind} report={report} />, document.getElementById("page")!);
