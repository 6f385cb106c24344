/**
 * The course editor's tools over the arena: passes pointers and keys to the chosen one and shows its picture. Loaded
 * with the palette; without it the hand still works.
 */
import type { Vec } from '#core/geometry';
import { copiesMade } from '#editor/clipboard';
import { handlesOf } from '#editor/handles';
import { figuresOf } from '#editor/snap/figures';
import { boundsOfSelection } from '#editor/selection';
import { nothingSelected, type ToolContext } from '#editor/tools/tool';
import { tools } from '#editor/tools/tools';
import { editProblem } from '#scene/check-edit';
import { applyEdit, type SceneEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import type { ArenaTool, CourseEditorModel } from '../../../course/editor/state/course-editor-model';
import { createSelectionActs } from '../../../course/editor/state/selection-acts';
import { t } from '../../../kit/i18n';
import { arenaKeys, type ArenaKeys } from './arena-keys';
import { arenaSight } from './arena-sight';
import { arenaOpenings, type ArenaOpenings } from './arena-openings';
import { drawEdit, editBox, objectsById, type EditFrame, type EditPicture } from './draw-edit';
import { floorPx } from '../picture/draw-floor';
import { ghostObjects, ghostOf, noGhost, type HeldParts } from './ghost';
import { createInkLayer } from './ink-layer';
import { movingWindow, type PxBox } from '../view/moving-window';
import type { Palette } from '../model/palette';
import { toolCursor } from './tool-cursors';
import { withPointKeys } from './point-keys';
import { createSelectionKeys, type SelectionKeyPorts } from './tool-keys';
import { toolPointers, type ToolPointers } from './tool-pointers';
import type { SurfacePicture, SurfacePorts } from './surface-ports';
import { ToolSurface } from './tool-surface';
import type { ArenaView } from '../view/use-arena-view';
import { createCarriedThings } from './carried-things';
import { hintPlace, readingPlace } from './draw-guides';
import type { ShownFigures } from './gesture';
import { measureText, readingText, readingWords, typedFieldText } from './reading-text';
import { toPx } from '../view/view-transform';
import arenaWords from '../words';

/** The surroundings of the tools. */
export interface ToolSources {
  readonly editor: CourseEditorModel;
  readonly picture: ArenaView;
  /** The document, without the changes made by the hand. */
  readonly course: () => Scene;
  /** Convex parts of the robot at scale 1 in its own frame, mm; empty: no robot. */
  readonly footprint: () => ToolContext['footprint'];
  readonly palette: () => Palette;
  /** The canvas for long lines. */
  readonly inkCanvas: () => HTMLCanvasElement | null;
  /** Requests a repaint of the editor's layer. */
  readonly redraw: () => void;
  readonly showGhost: (ghost: HeldParts) => void;
  /** Announces something to screen readers. */
  readonly say: (words: string) => void;
}

/** The tools over one arena. */
export interface ArenaTools extends ToolPointers, ArenaKeys {
  /** Call it after another tool is chosen. */
  toolChanged(): void;
  /** Call it after the course has changed: drops a gesture begun on the old one. */
  courseChanged(): void;
  readonly cursor: () => string;
  /** Zooms in on the selection. Returns false if there is none. */
  showSelected(): boolean;
  /** Place of the keyboard's crosshair, world mm, while it is shown. */
  readonly crosshair: () => Vec | null;
  /** Prepares the picture and returns its area, in CSS px; `null`: nothing to paint. Called before each `paint`. */
  place(): PxBox | null;
  paint(context: CanvasRenderingContext2D): void;
}

/** Makes the tools of one arena. */
export function createArenaTools(sources: ToolSources): ArenaTools {
  const { editor, picture } = sources;
  const [ink, carried] = [createInkLayer(), { ghost: createCarriedThings(), selected: createCarriedThings() }];
  const context = (): ToolContext => ({
    scene: sources.course(),
    selection: editor.selection.value,
    options: editor.options.value,
    footprint: sources.footprint(),
  });
  const ports = portsOf(sources, context, () => surface);
  const openings = arenaOpenings(sources);
  const surface: ToolSurface = surfaceOf(sources, ports, openings);
  const keys = withPointKeys(createSelectionKeys(ports), ports, surface, () => editor.tool.value === 'points');
  const unfinished = unfinishedOf(sources, surface);
  editor.view.value = arenaSight(sources, surface);
  const pointers = toolPointers(surface, (wish, rests) => openings.menu(wish, surface.reachMm, rests));
  let shown: { picture: EditPicture; frame: EditFrame } | null = null;
  let window: PxBox | null = null;

  function look(): typeof shown {
    const other = keys.edit ?? editor.brought.value;
    const now = withNudge(surface.picture(), other, context);
    const edit = now.edit ?? other;
    const course = sources.course();
    const after = now.after ?? (edit === null ? null : applyEdit(course, edit));
    const frame = { ...frameOf(sources), carried };
    tellSession(editor, edit, now);
    const canvas = sources.inkCanvas();
    if (canvas !== null) ink.paint(canvas, now.ink, frame, performance.now());
    const ghost = ghostObjects(course, after);
    sources.showGhost(ghostOf(ghost.hidden, course, after));
    return { frame, picture: editPicture(sources, { now, after, ghost: ghost.shown, drawn: ink.drawn, surface }) };
  }

  const showSelected = showingSelected(sources);
  return {
    ...pointers,
    ...arenaKeys({ ...sources, showSelected }, surface, keys, {
      pointers,
      openMenu: () => openings.menuByKeys(surface.crosshair),
    }),
    showSelected,
    toolChanged: () => surface.reset(),
    courseChanged: () => void surface.cancel(),
    crosshair: () => surface.crosshair,
    cursor: () => (surface.isPanning ? 'grabbing' : cursorOf(editor.tool.value)),
    place() {
      editor.unfinished.value = surface.isBusy ? unfinished : null;
      shown = editor.tool.value === 'hand' ? null : look();
      if (shown === null) sources.showGhost(noGhost);
      const box = shown && editBox(shown.frame, shown.picture);
      window = box && movingWindow(box, picture.canvas.value, picture.ratio.value, window);
      return window;
    },
    paint(on) {
      if (shown !== null) drawEdit(on, shown.frame, shown.picture);
    },
  };
}

/** Zooms in on the selection. Returns false if there is none. */
const showingSelected =
  ({ editor, picture, course, footprint }: ToolSources) =>
  (): boolean => {
    const box = boundsOfSelection(course(), editor.selection.value, footprint());
    if (box !== null) picture.showBox(box);
    return box !== null;
  };

const cursorOf = (tool: ArenaTool): string => (tool === 'hand' ? 'default' : toolCursor(tool));

/** The course with the unfinished drawing; `null` if it is unchanged or would become too large. */
const unfinishedOf =
  ({ course }: ToolSources, surface: ToolSurface) =>
  (): Scene | null => {
    const edit = surface.editSoFar();
    return edit === null || editProblem(course(), edit) !== null ? null : applyEdit(course(), edit);
  };

/** The ports through which keys and pointers read and change the course. */
function portsOf(
  sources: ToolSources,
  context: () => ToolContext,
  surface: () => ToolSurface,
): SelectionKeyPorts & Pick<SurfacePorts, 'done'> {
  const { editor } = sources;
  return {
    context,
    acts: createSelectionActs(editor, context),
    commit(edit, chosen) {
      const copies = copiesMade(sources.course(), edit);
      if (editor.commit(edit, chosen) && copies !== null) editor.clipboard.copies = copies; // Ctrl+D continues from them
    },
    done: (reading) => sources.say(readingWords(reading)),
    pointed() {
      const { crosshair, reachMm } = surface();
      const at = crosshair ?? surface().picture().hover;
      return at && { at, reachMm };
    },
    changed: sources.redraw,
  };
}

function surfaceOf(
  { editor, picture, course }: ToolSources,
  ports: SelectionKeyPorts & Pick<SurfacePorts, 'done'>,
  { open }: ArenaOpenings,
): ToolSurface {
  return new ToolSurface(
    {
      ...ports,
      open,
      select: editor.select,
      view: () => picture.view.value,
      arena: () => course().size,
      tool: () => (editor.tool.value === 'hand' ? null : tools[editor.tool.value]),
      isFree: () => editor.free.value,
      pan: (byPx) => picture.panBy(byPx),
      zoom: (factor, aroundPx) => picture.zoomBy(factor, aroundPx),
    },
    matchMedia('(pointer: coarse)').matches ? 'touch' : 'mouse',
  );
}

function frameOf(sources: ToolSources): Omit<EditFrame, 'carried'> {
  const { picture } = sources;
  const arena = sources.course().size;
  const view = picture.view.value;
  return {
    view,
    canvas: picture.canvas.value,
    ratio: picture.ratio.value,
    arena,
    palette: sources.palette(),
    floor: floorPx(view, arena),
    footprint: sources.footprint(),
  };
}

/** Passes the place of the pointer, the edit of the gesture and the ruler's measurement to the rest of the page. */
function tellSession(editor: CourseEditorModel, edit: SceneEdit | null, { marks, hover }: SurfacePicture): void {
  editor.pointer.value = hover;
  if (editor.drag.value !== edit) editor.drag.value = edit;
  const measured = marks.find((mark) => mark.type === 'measure') ?? null;
  const before = editor.measure.value;
  if (measured === null && before === null) return;
  if (measured !== null && before?.from === measured.from && before.to === measured.to) return;
  editor.measure.value = measured && { from: measured.from, to: measured.to };
}

/** Adds figures also while arrow keys move the selection, or while something is dragged in from beside the arena. */
function withNudge(now: SurfacePicture, edit: SceneEdit | null, context: () => ToolContext): SurfacePicture {
  if (edit === null) return now;
  const { reading, marks, frame } = figuresOf(edit, context(), null);
  const at = frame && { x: frame.x.mid, y: frame.y.max };
  return { ...now, marks, told: reading && at && { reading, typed: '', at, isFinger: false } };
}

/** The ruler's measurement, the typed numbers or the reading, with its place in world mm. */
function toldBy({
  told,
  marks,
  finger,
}: SurfacePicture): (Pick<ShownFigures, 'at' | 'isFinger'> & { text: string; isField: boolean }) | null {
  const measured = marks.find((mark) => mark.type === 'measure');
  const isFinger = finger !== null;
  if (measured) return { text: measureText(measured.from, measured.to), isField: false, at: measured.to, isFinger };
  if (told === null) return null;
  const { at, typed, reading } = told;
  if (typed !== '') return { text: typedFieldText(typed, reading), isField: true, at, isFinger };
  return reading && { text: readingText(reading), isField: false, at, isFinger };
}

interface Looked {
  readonly now: SurfacePicture;
  readonly after: Scene | null;
  readonly ghost: Scene['objects'];
  /** Number of the ink's places that the large canvas shows. */
  readonly drawn: number;
  readonly surface: ToolSurface;
}

function editPicture(sources: ToolSources, { now, after, ghost, drawn, surface }: Looked): EditPicture {
  const { editor, picture } = sources;
  const scene = after ?? sources.course();
  const told = toldBy(now);
  const tool = editor.tool.value === 'hand' ? null : editor.tool.value;
  const selection =
    tool === 'select' || tool === 'rotate' || tool === 'points' ? editor.selection.value : nothingSelected;
  const { penColor, penWidth } = editor.options.value;
  const isMoved = after !== null && after.robot !== sources.course().robot;
  const held = tool === 'start' ? { ids: [], robot: true } : selection;
  const showsStart = held.robot || isMoved;
  return {
    ghost,
    selected: objectsById(scene, selection.ids),
    start: showsStart && sources.footprint().length > 0 ? scene.robot : null,
    isStartSelected: selection.robot,
    handles:
      (tool === 'select' || tool === 'start') && now.told?.reading?.type !== 'moved'
        ? handlesOf(scene, held, sources.footprint(), surface.reachMm)
        : [],
    marks: now.marks,
    ink: now.ink && { ink: now.ink, from: Math.max(0, drawn - 1) },
    tip:
      tool === 'pen' && now.hover !== null
        ? { at: now.hover, width: penWidth, color: sources.palette().strokes[penColor] }
        : null,
    crosshair: now.crosshair,
    reading: told && {
      text: told.text,
      isField: told.isField,
      at: readingPlace(toPx(picture.view.value, told.at), told.isFinger, picture.canvas.value),
    },
    hint:
      now.crosshair?.isDown === true
        ? { text: t(arenaWords.tools.underWay), at: hintPlace(toPx(picture.view.value, now.crosshair.at)) }
        : null,
    // Figures replace the tool's sign.
    finger: tool !== null && now.finger !== null && told === null ? { at: now.finger, tool } : null,
  };
}
