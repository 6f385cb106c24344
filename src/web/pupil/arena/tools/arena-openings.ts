import type { Vec } from '#core/geometry';
import { boundsOfSelection, countOf, includes, only, takenBy, thingsAt } from '#editor/selection';
import type { Opened, ToolContext } from '#editor/tools/tool';
import type { Scene } from '#scene/scene';
import type { CourseEditorModel } from '../../../course/editor/state/course-editor-model';
import type { ArenaView } from '../view/use-arena-view';
import { placeOf } from '#editor/kinds/index';
import { toVec } from '#editor/plane';
import { toMm, toPx } from '../view/view-transform';
import type { MenuWish } from './tool-pointers';

/** Everything that opens over the arena: the menu for things, the text of a label, the points of a line or polygon. */
export interface ArenaOpenings {
  readonly open: (opened: Opened) => void;
  /**
   * Opens the menu for the things there; `rests`: requested by a resting finger, which only the select tool allows.
   * Returns whether it opens.
   */
  menu(wish: MenuWish, reachMm: number, rests: boolean): boolean;
  /** Opens the menu for the selection, or for the thing under the crosshair. */
  menuByKeys(crosshair: Vec | null): true;
}

/** Distance from the keyboard's crosshair that counts as on a thing, in mm. */
const KEY_REACH_MM = 9;

/** The surroundings of the openings. */
export interface OpeningSources {
  readonly editor: CourseEditorModel;
  readonly picture: ArenaView;
  readonly course: () => Scene;
  readonly footprint: () => ToolContext['footprint'];
  /** A canvas above the arena. */
  readonly inkCanvas: () => HTMLCanvasElement | null;
}

export function arenaOpenings(sources: OpeningSources): ArenaOpenings {
  const { editor, picture } = sources;
  const host = (): HTMLElement | null => sources.inkCanvas()?.parentElement ?? null;
  /** A place of the course in the window. */
  const inWindow = (atMm: Vec): Vec => {
    const box = host()?.getBoundingClientRect() ?? { left: 0, top: 0 };
    const at = toPx(picture.view.value, atMm);
    return { x: box.left + at.x, y: box.top + at.y };
  };

  function show(atMm: Vec, { x: xPx, y: yPx }: Vec, on: 'things' | 'floor'): void {
    editor.menu.value = { xPx, yPx, atMm, on, host: host(), fit: () => picture.fit() };
  }

  /** Selects the topmost thing at a place, locked or not, unless one there is selected. Returns what the menu is for. */
  function take(atMm: Vec, reachMm: number): 'things' | 'floor' {
    const selection = editor.selection.value;
    const things = thingsAt(sources.course(), atMm, reachMm, sources.footprint(), () => true);
    const [topmost] = things;
    if (topmost === undefined) return 'floor';
    if (things.some((thing) => includes(selection, thing))) return 'things';
    editor.choose('select');
    if (editor.tool.value !== 'select') return 'floor'; // the open task locks the course
    editor.select(takenBy(sources.course(), topmost, selection));
    return 'things';
  }

  function middleOfSelected(): Vec | null {
    const around = boundsOfSelection(sources.course(), editor.selection.value, sources.footprint());
    return around && { x: (around.minX + around.maxX) / 2, y: (around.minY + around.maxY) / 2 };
  }

  return {
    open({ part, id }) {
      const object = sources.course().objects.find((one) => one.id === id);
      if (object === undefined) return;
      editor.select(only(id));
      if (part === 'points') editor.choose('points');
      if (part !== 'words') return;
      const { x, y } = inWindow(toVec(placeOf(object)));
      editor.words.value = { id, xPx: x, yPx: y, host: host() };
    },
    menu({ at, inWindow: place }, reachMm, rests) {
      if (rests && editor.tool.value !== 'select') return false;
      const atMm = toMm(picture.view.value, at);
      show(atMm, place, take(atMm, reachMm));
      return true;
    },
    menuByKeys(crosshair) {
      const on =
        crosshair === null ? (countOf(editor.selection.value) > 0 ? 'things' : 'floor') : take(crosshair, KEY_REACH_MM);
      const { widthPx, heightPx } = picture.canvas.value;
      const atMm = crosshair ?? middleOfSelected() ?? toMm(picture.view.value, { x: widthPx / 2, y: heightPx / 2 });
      show(atMm, inWindow(atMm), on);
      return true;
    },
  };
}
