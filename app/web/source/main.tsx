// Starts the page: style, colours, the server's events, then the workbench itself.
import "./style/fonts.css";
import "uplot/dist/uPlot.min.css";
import "../../drawing/colours.css";
import "./style/tokens.css";
import "./style/page.css";
import "./style/views.css";
import {render} from "preact";
import {followChosenColours} from "./drawing/colours";
import {dropTokenFromAddress, followServer} from "./server/workbench";
import {Workbench} from "./shell/workbench";

dropTokenFromAddress();
followChosenColours();
followServer();
render(<Workbench />, document.getElementById("page")!);
