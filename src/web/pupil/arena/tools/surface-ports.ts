import type { Vec } from '#core/geometry';
import type { Reading } from '#editor/snap/reading';
import type { Mark, Opened, Selection, Tool, ToolContext } from '#editor/tools/tool';
import type { SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import type { PicturePorts } from '../view/pinch';
import type { ArenaSize, View } from '../view/view-transform';
import type { Ink, ShownFigures } from './gesture';

/** Everything the surface reads and changes. */
export interface SurfacePorts extends PicturePorts {
  readonly view: () => View;
  readonly arena: () => ArenaSize;
  /** The chosen tool, or `null` for none. */
  readonly tool: () => Tool | null;
  readonly context: () => ToolContext;
  /** True if snapping is switched off. */
  readonly isFree: () => boolean;
  readonly commit: (edit: SceneEdit, select?: Selection) => void;
  readonly select: (selection: Selection) => void;
  /** Called with the figures of a gesture that has changed the course. */
  readonly done: (reading: Reading) => void;
  /** Opens the contents of a thing after a double tap. */
  readonly open: (opened: Opened) => void;
  /** Called when the picture has changed. */
  readonly changed: () => void;
}

/** The picture of a tool at one moment. */
export interface SurfacePicture {
  /** The result of the gesture so far, and the course with it. */
  readonly edit: SceneEdit | null;
  readonly after: Scene | null;
  readonly ink: Ink | null;
  readonly marks: readonly Mark[];
  /** The crosshair of the keyboard, world mm, and whether it draws. */
  readonly crosshair: { readonly at: Vec; readonly isDown: boolean } | null;
  /** The figures beside the pointer: their place, world mm, and whether a finger covers it. */
  readonly told: ShownFigures | null;
  /** Place where a finger draws and covers the picture; world mm. */
  readonly finger: Vec | null;
  /** Place of the pointer with nothing pressed, world mm. */
  readonly hover: Vec | null;
}

/** The empty picture. */
export const NOTHING: SurfacePicture = {
  edit: null,
  after: null,
  ink: null,
  marks: [],
  told: null,
  crosshair: null,
  finger: null,
  hover: null,
};
