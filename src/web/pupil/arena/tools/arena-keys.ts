import type { Vec } from '#core/geometry';
import type { Texts } from '#core/languages';
import { nothingSelected } from '#editor/tools/tool';
import { tools } from '#editor/tools/tools';
import type { CourseEditorModel } from '../../../course/editor/state/course-editor-model';
import { t } from '../../../kit/i18n';
import { arrowOf, STEP_MM, type SelectionKeys } from './tool-keys';
import type { ToolPointers } from './tool-pointers';
import type { ToolSurface } from './tool-surface';
import type { ArenaView } from '../view/use-arena-view';
import { toMm } from '../view/view-transform';
import arenaWords from '../words';
import { readingWords } from './reading-text';

/** The keys of the arena while a tool is chosen. */
export interface ArenaKeys {
  /** Returns whether the key was used. */
  keyDown(event: KeyboardEvent): boolean;
  keyUp(event: KeyboardEvent): void;
  /** Handles focus that the arena has got by the keyboard. */
  focus(): void;
  blur(): void;
}

/** Sources of the keys. */
export interface KeySources {
  readonly editor: CourseEditorModel;
  readonly picture: ArenaView;
  /** Zooms in on the selection. Returns false if there is none. */
  readonly showSelected: () => boolean;
  /** Announces something to screen readers. */
  readonly say: (words: string) => void;
}

/** Shortest rest of the crosshair before its place is announced, in ms: a held arrow key announces only the end. */
const SAY_MS = 350;

/** The keys of the arena while a tool is chosen. */
export function arenaKeys(
  sources: KeySources,
  surface: ToolSurface,
  keys: SelectionKeys,
  { pointers, openMenu }: { readonly pointers: ToolPointers; readonly openMenu: () => boolean },
): ArenaKeys {
  const { editor, picture } = sources;
  const tellPlace = sayer(sources, surface);
  const middle = (): Vec => middleOfSight(picture);
  const press = (drags: boolean): void => {
    if (!surface.pressKey(middle(), drags)) return; // the editor announces what was done
    if (surface.crosshair !== null) sources.say(sayPlace(arenaWords.tools.drawing, surface.crosshair));
  };
  const step = (arrow: Vec, fine: boolean): void => {
    const mm = fine ? STEP_MM.fine : STEP_MM.coarse;
    const at = surface.moveCrosshair({ x: arrow.x * mm, y: arrow.y * mm }, middle(), fine);
    pointers.keepInSight(picture, at);
    tellPlace(at);
  };
  return {
    keyDown(event) {
      const { key, shiftKey, repeat } = event;
      const command = event.ctrlKey || event.metaKey;
      if (key === 'Alt') return surface.isBusy; // it copies, and opens no menu of the browser
      if (event.altKey) return false;
      if (key === 'ContextMenu' || (key === 'F10' && shiftKey)) return openMenu();
      if (!command && surface.type(key)) return sayTyped(sources, surface);
      if (key === 'Escape') return escape(sources, surface);
      if (shiftKey && !command && event.code === 'Digit2') return sources.showSelected();
      if (surface.isChaining && (key === 'Backspace' || key === 'Delete')) {
        surface.takeCornerBack();
        return true;
      }
      // An arrow draws when the keyboard has begun something, even where something is selected.
      if (!surface.isBusy && keys.keyDown(key, shiftKey, command)) return true;
      if (command) return false;
      const arrow = arrowOf(key);
      if (arrow !== null) step(arrow, shiftKey);
      else if (key === ' ' && !repeat) pointers.holdSpace();
      else if (key === 'Enter' && !repeat) press(shiftKey);
      return arrow !== null || key === ' ' || key === 'Enter';
    },
    keyUp(event) {
      keys.keyUp(event.key);
      if (event.key === ' ' && pointers.letGoSpace()) press(event.shiftKey);
    },
    focus: () => sources.say(t(arenaWords.tools[helpFor(editor)])),
    blur() {
      pointers.letGoSpace();
      keys.keyUp('ArrowLeft'); // any arrow: the move is finished
      surface.blur();
    },
  };
}

/**
 * Cancels the current gesture, or else leaves the points of a line, or else clears the selection. Returns false if
 * there was nothing to leave.
 */
function escape({ editor, say: tell }: KeySources, surface: ToolSurface): boolean {
  if (surface.cancel()) tell(t(arenaWords.tools.dropped));
  else if (editor.tool.value === 'points') editor.choose('select');
  else if (isSelected(editor)) editor.select(nothingSelected);
  else return false;
  return true;
}

/** Announces the numbers typed so far; the key was used for them. */
function sayTyped(sources: KeySources, { told }: ToolSurface): true {
  if (told !== null && told.typed !== '') sources.say(told.typed);
  return true;
}

/** Announces the place of the crosshair as soon as it rests, and the figures of the gesture. */
function sayer(sources: KeySources, surface: ToolSurface): (at: Vec) => void {
  let timer: ReturnType<typeof setTimeout> | null = null;
  return (at) => {
    if (timer !== null) clearTimeout(timer);
    timer = setTimeout(() => {
      const told = surface.told;
      const place = sayPlace(arenaWords.tools.place, at);
      sources.say(told?.reading ? `${place}, ${readingWords(told.reading)}` : place);
    }, SAY_MS);
  };
}

const sayPlace = (text: Texts, at: Vec): string => t(text, { x: cm(at.x), y: cm(at.y) });

/** Middle of the visible area, world mm. */
function middleOfSight({ view, canvas }: ArenaView): Vec {
  return toMm(view.value, { x: canvas.value.widthPx / 2, y: canvas.value.heightPx / 2 });
}

function helpFor(editor: CourseEditorModel): 'help' | 'helpPuts' | 'helpSelected' {
  if (isSelected(editor)) return 'helpSelected';
  const tool = editor.tool.value;
  return tool !== 'hand' && tools[tool].putsDown === true ? 'helpPuts' : 'help';
}

const isSelected = ({ selection }: CourseEditorModel): boolean =>
  selection.value.robot || selection.value.ids.length > 0;

/** In cm, to the mm. */
const cm = (mm: number): string => String(Math.round(mm) / 10);
