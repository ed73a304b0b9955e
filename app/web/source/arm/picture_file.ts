// The 3-D picture as a file: a PNG of the present view, and a film of it while it moves.
import {palette} from "../drawing/colours";
import {cell} from "../server/workbench";
import type {ArmStage} from "./arm_stage";

function download(content: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** Returns a file name of the opened cell, such as "mockup-arm.png". */
function nameOf(what: string, ending: string): string {
  return `${cell.peek()?.name ?? "cell"}-${what}.${ending}`;
}

/** Saves the picture in twice its size on the screen, on the colour of the page's panels. */
export function savePicture(stage: ArmStage): void {
  const drawn = stage.drawnCanvas(2);
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [drawn.width, drawn.height];
  const context = canvas.getContext("2d")!;
  context.fillStyle = palette.peek().panel;
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.drawImage(drawn, 0, 0);
  canvas.toBlob((content) => content && download(content, nameOf("arm", "png")), "image/png");
}

const KINDS: readonly (readonly [string, string])[] = [
  ["video/webm;codecs=vp9", "webm"],
  ["video/webm;codecs=vp8", "webm"],
  ["video/mp4", "mp4"],
];

/** Returns the film format that this browser can record; null if it can record none. */
function filmKind(): readonly [string, string] | null {
  if (typeof MediaRecorder === "undefined") return null;
  return KINDS.find(([type]) => MediaRecorder.isTypeSupported(type)) ?? null;
}

export interface Film {
  /** Ends the film and saves it. */
  end: () => void;
}

/** Starts a video recording of the stage; returns null if the browser does not support recording. */
export function beginFilm(stage: ArmStage, pictures = 30): Film | null {
  const kind = filmKind();
  if (!kind) return null;
  const [mimeType, ending] = kind;
  const endGround = stage.paintGround(palette.peek().panel);
  const recorder = new MediaRecorder(stage.canvas.captureStream(pictures), {mimeType, videoBitsPerSecond: 6_000_000});
  const parts: Blob[] = [];
  recorder.addEventListener("dataavailable", ({data}) => parts.push(data));
  recorder.addEventListener("stop", () => {
    endGround();
    download(new Blob(parts, {type: mimeType.split(";")[0]}), nameOf("path", ending));
  });
  recorder.start(1000);
  return {end: () => recorder.state !== "inactive" && recorder.stop()};
}
