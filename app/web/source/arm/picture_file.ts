// The 3-D picture as a file: a PNG of the present view.
import {palette} from "../drawing/colours";
import {cell} from "../server/workbench";
import type {ArmStage} from "./arm_stage";

/** Saves content as a file of the user. */
export function download(content: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** Returns a file name of the opened cell, such as "mockup-arm.png". */
export function nameOf(what: string, ending: string): string {
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
