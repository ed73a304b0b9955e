// The 3-D picture: the sheet, the bowl and obstacles, the rigid arm as a ghost, the deflected arm, and the line to the
// nearest object. The picture is drawn only after a change.
import {
  AmbientLight,
  Box3,
  Color,
  DirectionalLight,
  Group,
  MeshStandardMaterial,
  PerspectiveCamera,
  Scene,
  Sphere,
  Vector3,
  WebGLRenderer,
} from "three";
import {pixelRatio} from "../drawing/canvas";
import {signal} from "@preact/signals";
import {OrbitControls} from "three/examples/jsm/controls/OrbitControls.js";
import type {Palette} from "../drawing/colours";
import type {ReadingErrors} from "../error/residuals";
import type {Frame, JointInfo, PoseDocument, SceneDocument} from "../server/documents";
import type {SheetModel} from "../sheet/sheet_model";
import {magnifiedFrame, makeArm, placeArm, type ArmBodies, type ArmLook} from "./arm_bodies";
import {errorArrows} from "./error_arrow";
import {errorField, fadeField} from "./error_field";
import {axesOf, axisLines, type JointAxis} from "./joint_axes";
import type {ShownReading} from "./pose_link";
import {floorOf, plateOf} from "./sheet_plate";
import {clearanceLine, TOUR, tourLine} from "./stage_lines";
import {bowlOf, disposeAll, obstacleOf, openingOf, vector} from "./solids";

/** True if pictures are drawn without a graphics processor, such as on a bare server or over a remote desktop. */
const IS_SOFTWARE = (() => {
  const context = document.createElement("canvas").getContext("webgl2");
  const name = context?.getExtension("WEBGL_debug_renderer_info");
  const words = context && name ? String(context.getParameter(name.UNMASKED_RENDERER_WEBGL)) : "";
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(words);
})();

/**
 * Distance from the middle of the picture to its edge, in the cell's unit of length. Dimensions that the cell does not
 * determine are stated relative to this distance.
 */
export const pictureReach = signal(1);

/** Stage of the view that is open; null if none is. */
export const openStage = signal<ArmStage | null>(null);

/** Reach of the picture without a sheet, relative to the total length of the arm's members. */
const REACH_WITHOUT_SHEET = 0.7;
/** Relative change of the arm's length beyond which the view is fitted again, as for another arm. */
const SAME_ARM = 0.3;

function empty(group: Group): void {
  disposeAll(group);
  group.clear();
}

function lengthAlong(places: readonly Vector3[]): number {
  return places.slice(1).reduce((sum, place, i) => sum + place.distanceTo(places[i]), 0);
}

export class ArmStage {
  readonly camera = new PerspectiveCamera(34, 1, 0.01, 100);
  private readonly scene = new Scene();
  private readonly renderer: WebGLRenderer;
  private readonly controls: OrbitControls;
  private readonly statics = new Group();
  private readonly marks = new Group();
  private readonly errors = new Group();
  private readonly field = new Group();
  private readonly axisGroup = new Group();
  private joints: readonly JointInfo[] = [];
  private shownFrames: Frame[] = [];
  /** Axes drawn now, whose ends carry the names of the joints. */
  axes: JointAxis[] = [];
  private armLook: ArmLook = "shapes";
  private ghost: ArmBodies | null = null;
  private solid: ArmBodies | null = null;
  private isDisposed = false;
  private isRequested = false;
  private film: {width: number; onPicture: () => void} | null = null;
  private reach = 1;
  private length = 0;
  private cell: {document: SceneDocument; sheet: SheetModel | null} | null = null;
  private focus = new Vector3();
  private pose: PoseDocument | null = null;
  private magnified = 1;
  private ratio = 1;
  private later = 0;
  private notBefore = 0;
  private palette: Palette | null = null;
  onDraw: (() => void) | null = null;

  constructor(readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({canvas, antialias: !IS_SOFTWARE, alpha: true});
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.requestFrame());
    this.scene.add(new AmbientLight(0xffffff, 1.5));
    const sun = new DirectionalLight(0xffffff, 2.1);
    sun.position.set(0.5, -0.9, 0.9);
    const fill = new DirectionalLight(0xffffff, 0.8);
    fill.position.set(-0.8, 0.6, -0.6);
    this.scene.add(sun, fill, this.statics, this.marks, this.errors, this.field, this.axisGroup);
  }

  dispose(): void {
    this.isDisposed = true;
    clearTimeout(this.later);
    disposeAll(this.scene);
    this.controls.dispose();
    this.renderer.dispose();
  }

  resize(width: number, height: number): void {
    if (width < 2 || height < 2) return;
    this.ratio = IS_SOFTWARE ? 0.6 : pixelRatio();
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.drawNow();
  }

  requestFrame(): void {
    if (this.isRequested) return;
    this.isRequested = true;
    const wait = this.notBefore - performance.now();
    if (wait > 4) setTimeout(() => requestAnimationFrame(() => this.drawNow()), wait);
    else requestAnimationFrame(() => this.drawNow());
  }

  private drawNow(isSharp = false): void {
    if (this.isDisposed) return; // the frame was requested before the disposal
    this.isRequested = false;
    const filmRatio = (this.film?.width ?? 0) / this.canvas.clientWidth;
    this.renderer.setPixelRatio(this.film ? filmRatio : isSharp ? pixelRatio() : this.ratio);
    this.renderer.render(this.scene, this.camera);
    this.film?.onPicture();
    this.onDraw?.();
    clearTimeout(this.later);
    if (isSharp || this.film) return;
    const end = performance.now();
    setTimeout(() => this.adapt(performance.now() - end));
    if (this.ratio < pixelRatio()) this.later = window.setTimeout(() => this.drawNow(true), 400);
  }

  /** Lowers the resolution during motion if drawing is slow (no graphics processor); a picture at rest is sharp. */
  private adapt(msWaited: number): void {
    // Delays the next picture, by at most 400 ms, so that numbers are updated first.
    if (msWaited > 12) this.notBefore = performance.now() + Math.min(2 * msWaited, 400);
    if (msWaited > 24) this.ratio = Math.max(0.45, 0.8 * this.ratio);
    else if (msWaited < 10 && !IS_SOFTWARE) this.ratio = Math.min(pixelRatio(), 1.1 * this.ratio);
  }

  /** Shows the fixed objects of a cell and the bodies of the arm. */
  setCell(document: SceneDocument, sheet: SheetModel | null, palette: Palette): void {
    this.palette = palette;
    this.cell = {document, sheet};
    if (sheet) this.frame(sheet.radius, new Vector3(0, sheet.isOneLeg ? 0.42 * sheet.radius : 0, -0.38 * sheet.radius));
    else if (this.pose) this.frameArm(this.pose);
    this.build(document, sheet, palette);
    if (this.pose) this.setPose(this.pose, this.magnified);
    this.requestFrame();
  }

  private frame(reach: number, focus: Vector3): void {
    this.reach = pictureReach.value = reach;
    this.focus.copy(focus);
    this.camera.near = 0.005 * reach;
    this.camera.far = 40 * reach;
    this.camera.updateProjectionMatrix();
  }

  /** Fits the view to the arm in its posture, for a cell without a sheet. */
  private frameArm(pose: PoseDocument): void {
    const places = [...pose.frames.rigid.map((frame) => vector(frame.position)), vector(pose.tip.rigid)];
    this.length = lengthAlong(places);
    if (this.length > 0)
      this.frame(REACH_WITHOUT_SHEET * this.length, new Box3().setFromPoints(places).getCenter(new Vector3()));
  }

  private build(document: SceneDocument, sheet: SheetModel | null, palette: Palette): void {
    empty(this.statics);
    const colours = {fill: palette.rim, edge: palette.muted};
    const wall = document.shapes.find((shape) => shape.kind === "keep_side" && Math.abs(shape.normal?.[1] ?? 0) > 0.5);
    const side = Math.sign(wall?.normal?.[1] ?? 0) as -1 | 0 | 1;
    for (const shape of document.shapes) {
      const object = shape.kind === "inside_of.sphere" ? bowlOf(shape, side, colours) : obstacleOf(shape, colours);
      if (object) this.statics.add(object);
    }
    if (sheet) this.statics.add(plateOf(sheet, palette));
    else this.statics.add(floorOf(palette, this.reach));
    const {center, diameter} = sheet?.manway ?? {};
    if (center && diameter) this.statics.add(openingOf(center, diameter, colours));
    this.replaceArms(document, palette);
  }

  private replaceArms(document: SceneDocument, palette: Palette): void {
    for (const arm of [this.ghost, this.solid]) {
      if (!arm) continue;
      disposeAll(arm.group);
      this.scene.remove(arm.group);
    }
    const faint = {transparent: true, opacity: 0.2, depthWrite: false, roughness: 1};
    this.ghost = makeArm(
      document,
      new MeshStandardMaterial({color: palette.case0, ...faint}),
      this.reach,
      this.armLook,
    );
    const look = new MeshStandardMaterial({color: palette.accent, roughness: 0.55, metalness: 0.1});
    this.solid = makeArm(document, look, this.reach, this.armLook);
    this.scene.add(this.ghost.group, this.solid.group);
  }

  /**
   * Selects a standard view. One leg of the sheet is viewed from the side of the divider, where the bowl is cut open.
   */
  look(from: "corner" | "side" | "below" | "front"): void {
    const directions = {
      corner: [-1.25, -2.35, -0.42],
      side: [-2.7, -0.02, -0.2],
      below: [0, -0.02, -2.7],
      front: [0.05, -2.7, -0.2],
    } as const;
    const way = new Vector3(...directions[from]);
    if (!this.cell?.sheet && from !== "below") way.z *= -1; // without a sheet, nothing hides the arm from above
    this.controls.target.copy(this.focus);
    this.camera.position
      .copy(this.focus)
      .add(way.multiplyScalar(1.12 * this.reach * Math.max(1, 1.3 / this.camera.aspect)));
    this.controls.update();
    this.requestFrame();
  }

  /** Moves the camera, without turning it, so that the arm and the given places fill the picture. */
  fit(places: readonly (PoseDocument["tip"]["rigid"] | null)[]): void {
    const points = places.flatMap((place) => (place ? [vector(place)] : []));
    if (this.pose)
      points.push(...this.shownFrames.map((frame) => vector(frame.position)), vector(this.pose.tip.flexible));
    if (points.length < 2) return;
    const ball = new Box3().setFromPoints(points).getBoundingSphere(new Sphere());
    const way = this.camera.position.clone().sub(this.controls.target).normalize();
    const half = Math.sin((0.5 * this.camera.fov * Math.PI) / 180) * Math.min(1, this.camera.aspect);
    this.controls.target.copy(ball.center);
    this.camera.position.copy(ball.center).addScaledVector(way, (1.08 * ball.radius) / half);
    this.controls.update();
    this.requestFrame();
  }

  setPose(pose: PoseDocument, magnified: number): void {
    this.pose = pose;
    this.magnified = magnified;
    if (this.isOtherArm(pose) && this.cell && this.palette) {
      this.frameArm(pose);
      this.build(this.cell.document, null, this.palette);
      this.look("corner");
    }
    if (!this.ghost || !this.solid || !this.palette) return;
    placeArm(this.ghost, pose.frames.rigid, vector(pose.tip.rigid));
    const frames = pose.frames.flexible.map((frame, i) => magnifiedFrame(pose.frames.rigid[i], frame, magnified));
    const rigidTip = vector(pose.tip.rigid),
      sag = vector(pose.tip.flexible).sub(rigidTip);
    placeArm(this.solid, frames, rigidTip.addScaledVector(sag, magnified));
    this.shownFrames = frames;
    this.drawAxes();
    this.drawClearance(pose, this.palette);
    this.requestFrame();
  }

  private isOtherArm(pose: PoseDocument): boolean {
    if (!this.cell || this.cell.sheet) return false;
    const length = lengthAlong([...pose.frames.rigid.map((frame) => vector(frame.position)), vector(pose.tip.rigid)]);
    return length > 0 && Math.abs(this.length / length - 1) > SAME_ARM;
  }

  /**
   * Draws the line to the nearest object, except with magnified deflection, where the drawn arm is not at its true
   * position.
   */
  private drawClearance(pose: PoseDocument, palette: Palette): void {
    empty(this.marks);
    const {clearance} = pose;
    if (!clearance || !clearance.to || this.magnified !== 1) return;
    this.marks.add(clearanceLine(vector(clearance.from), vector(clearance.to), this.reach, palette));
  }

  /** Draws the arm by its bodies or as a skeleton. */
  setLook(look: ArmLook): void {
    if (look === this.armLook) return;
    this.armLook = look;
    if (!this.cell || !this.palette) return;
    this.replaceArms(this.cell.document, this.palette);
    if (this.pose) this.setPose(this.pose, this.magnified);
    this.requestFrame();
  }

  /** Shows the axes of these joints; an empty list hides them. */
  setAxes(joints: readonly JointInfo[]): void {
    this.joints = joints;
    this.drawAxes();
    this.requestFrame();
  }

  private drawAxes(): void {
    empty(this.axisGroup);
    this.axes = axesOf(this.joints, this.shownFrames, this.reach);
    if (this.axes.length > 0 && this.palette) this.axisGroup.add(axisLines(this.axes, this.palette));
  }

  /** Returns the canvas just after drawing the picture sharply; `times` is its size relative to the screen. */
  drawnCanvas(times: number): HTMLCanvasElement {
    this.renderer.setPixelRatio(times);
    this.renderer.render(this.scene, this.camera);
    this.requestFrame();
    return this.canvas;
  }

  /**
   * Draws `width` pixels wide on a ground of one colour, for a film; `onPicture` may read the canvas just after each
   * drawing. Returns a function that ends the film.
   */
  beginFilm(colour: string, width: number, onPicture: () => void): () => void {
    this.scene.background = new Color(colour);
    this.film = {width, onPicture};
    this.requestFrame();
    return () => {
      this.scene.background = null;
      this.film = null;
      this.requestFrame();
    };
  }

  /** Shows the errors of the reading whose posture the arm shows; null hides them. */
  setReading(reading: ShownReading | null, palette: Palette): void {
    empty(this.errors);
    if (reading) this.errors.add(errorArrows(reading, this.reach, palette));
    this.requestFrame();
  }

  /** Shows the errors of all readings, coloured by their series or by their size; null hides them. */
  setErrors(errors: ReadingErrors | null, palette: Palette, isBySize: boolean): void {
    empty(this.field);
    if (errors) this.field.add(errorField(errors, this.reach, palette, isBySize));
    this.requestFrame();
  }

  /** Blends the errors of all readings from before (0) to after (1). */
  fadeErrors(after: number): void {
    for (const field of this.field.children) fadeField(field as Group, after);
    this.requestFrame();
  }

  /** Shows a tour through the tip positions in the order of visiting; null hides the tour. */
  setTour(points: Vector3[] | null, palette: Palette): void {
    const old = this.statics.getObjectByName(TOUR);
    if (old) {
      disposeAll(old);
      this.statics.remove(old);
    }
    if (points && points.length > 1) this.statics.add(tourLine(points, this.reach, palette));
    this.requestFrame();
  }

  /** Returns the position of a world point on the canvas [pixels]; null if the point is behind the camera. */
  onScreen(point: Vector3): [number, number] | null {
    const seen = point.clone().project(this.camera);
    if (seen.z > 1) return null;
    return [((seen.x + 1) / 2) * this.canvas.clientWidth, ((1 - seen.y) / 2) * this.canvas.clientHeight];
  }
}
