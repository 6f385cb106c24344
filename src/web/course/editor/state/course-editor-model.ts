import { computed, onScopeDispose, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';

import type { Vec } from '#core/geometry';
import { usualToolOptions } from '#editor/tools/tool-options';
import { nothingSelected, type Selection, type ToolId, type ToolOptions } from '#editor/tools/tool';
import type { SceneEdit } from '#scene/edit';
import type { SceneProblem } from '#scene/problem';
import type { Scene } from '#scene/scene';

import { Clipboard } from './clipboard';
import { waitsForStart } from './waiting';
import type { ModeModel } from '../../../session/mode/mode-model';
import type { WorkModel } from '../../../session/work/model/work-model';

/** The action of a pointer in the arena: a tool edits the course, the hand reaches into the run. */
export type ArenaTool = ToolId | 'hand';

/** The part of the editor that is loaded on first use. */
export interface EditorParts {
  /** Why an edit would exceed the limits of a course, or `null`. */
  problemOf(scene: Scene, edit: SceneEdit): SceneProblem | null;
  /** An edit with what goes along: tags that are stuck to what it moves. */
  whole(scene: Scene, edit: SceneEdit): SceneEdit;
  /** Says to screen readers what happened. */
  wordsFor(happened: Happened): string;
}

/** Something to announce to screen readers. */
export type Happened =
  /** `scene`: the course before the edit. */
  | { readonly type: 'edit' | 'undo' | 'redo'; readonly scene: Scene; readonly edit: SceneEdit }
  | { readonly type: 'problem'; readonly problem: SceneProblem }
  | { readonly type: 'selected'; readonly selection: Selection; readonly scene: Scene }
  | { readonly type: 'tool'; readonly tool: ArenaTool }
  /** The selection was copied: nothing looks different. */
  | { readonly type: 'copied' };

/** Place of the menu for things in the arena. */
export interface MenuPlace {
  /** In the window, px. */
  readonly xPx: number;
  readonly yPx: number;
  readonly atMm: Vec;
  /** For what is selected, or for the arena. */
  readonly on: 'things' | 'floor';
  /** Gets the keyboard back. */
  readonly host: HTMLElement | null;
  /** Shows the whole arena. */
  readonly fit: () => void;
}

/** A label whose words are being changed in its place: its middle in the window, px. */
export interface WordsPlace {
  readonly id: string;
  readonly xPx: number;
  readonly yPx: number;
  /** Gets the keyboard back. */
  readonly host: HTMLElement | null;
}

/** The visible part of the arena, for features that bring something from beside it. */
export interface EditorView {
  /** The place of the arena (world mm) at a place of the window (px); `null`: it is beside the picture. */
  readonly at: (xPx: number, yPx: number) => Vec | null;
  /** The middle of what is seen, world mm. @param abovePx what lies below this, in the window, is covered */
  readonly middle: (abovePx: number) => Vec;
  /** How near counts as on a thing, in mm. */
  readonly reachMm: () => number;
  /** Brings a place (world mm) into sight and lets it flash. */
  readonly show: (atMm: Vec) => void;
}

/** The state of the course editor: the chosen tool, its options, the selection. Session state, never in a file. */
export interface CourseEditorModel {
  /** The hand wherever nothing is built; what was chosen comes back with building. */
  readonly tool: ComputedRef<ArenaTool>;
  readonly options: Readonly<ShallowRef<ToolOptions>>;
  readonly selection: Readonly<ShallowRef<Selection>>;
  /** True while the course is built: then the tools are there, and only then do they work. */
  readonly isOpen: ComputedRef<boolean>;
  /** True if snapping is off. */
  readonly free: ShallowRef<boolean>;
  /** The result of the gesture so far; `null` for none. */
  readonly drag: ShallowRef<SceneEdit | null>;
  /** A thing held over the arena from beside it, as it would be placed; `null`: none. */
  readonly brought: ShallowRef<SceneEdit | null>;
  /** The visible part of the arena; `null` until the tools are loaded. */
  readonly view: ShallowRef<EditorView | null>;
  /** The course as it would be if the gesture ended now; `null` if none is under way. Saved with the work. */
  readonly unfinished: WorkModel['unfinished'];
  /** The ruler's ends, in world mm; `null`: nothing measured yet. */
  readonly measure: ShallowRef<{ readonly from: Vec; readonly to: Vec } | null>;
  /** The course with which the run on show began; `null` without a run. */
  readonly runStart: Readonly<ShallowRef<Scene | null>>;
  /** True if the run has yet to pick up changes that need a new start: walls, fixed things, the robot's start. */
  readonly isWaiting: ComputedRef<boolean>;
  /** The announcement of what has just happened. */
  readonly said: Readonly<ShallowRef<string>>;
  /** Why the last edit was refused, or `null`. */
  readonly problem: ShallowRef<SceneProblem | null>;
  readonly clipboard: Clipboard;
  /** Place of the pointer over the arena, world mm; `null`: elsewhere, or a finger. */
  readonly pointer: ShallowRef<Vec | null>;
  /** The menu for things in the arena; `null`: closed. */
  readonly menu: ShallowRef<MenuPlace | null>;
  /** The label that is being changed in its place; `null`: none. */
  readonly words: ShallowRef<WordsPlace | null>;
  /** Says to screen readers what happened. */
  readonly tell: (happened: Happened) => void;
  readonly choose: (tool: ArenaTool) => void;
  readonly setOptions: (part: Partial<ToolOptions>) => void;
  readonly select: (selection: Selection) => void;
  /**
   * Applies an edit to the course and the run, as one step to undo. Returns whether it was accepted: nothing is while
   * nothing is built.
   */
  readonly commit: (edit: SceneEdit, select?: Selection) => boolean;
  /** The same for a window on the course that belongs to no mode. */
  readonly apply: (edit: SceneEdit) => boolean;
  readonly undo: () => void;
  readonly redo: () => void;
  /** Called by the part that is loaded on first use. */
  readonly join: (parts: EditorParts) => void;
}

/** The models that the editor depends on. */
export interface EditorSurroundings {
  readonly work: WorkModel;
  readonly mode: Pick<ModeModel, 'current'>;
  readonly runStart: Readonly<ShallowRef<Scene | null>>;
  /** True if a run is under way. */
  readonly isActive: Readonly<ShallowRef<boolean>>;
}

/** Creates the course editor's state, which lives as long as the app. */
export function createCourseEditor(around: EditorSurroundings): CourseEditorModel {
  const editor = new CourseEditor(around);
  // Removed objects must not stay selected.
  watch(around.work.scene, (scene) => editor.forgetGone(scene), { flush: 'sync' });
  watch(around.work.openings, () => editor.reset());
  onScopeDispose(
    around.work.onStep(({ type, step, without }) => editor.tell({ type, scene: without, edit: step.edit })),
  );
  // What is selected can be changed: it is only while something is built.
  watch(editor.isOpen, (open) => {
    if (!open) editor.letGo();
  });
  return editor;
}

/** The functions of the model are bound to it and can be passed on alone. */
class CourseEditor implements CourseEditorModel {
  readonly tool: ComputedRef<ArenaTool>;
  /** `null`: none yet. Building begins with selecting. */
  private readonly chosen = shallowRef<ArenaTool | null>(null);
  readonly options = shallowRef<ToolOptions>(usualToolOptions);
  readonly selection = shallowRef(nothingSelected);
  readonly free = shallowRef(false);
  readonly drag = shallowRef<SceneEdit | null>(null);
  readonly brought: CourseEditorModel['brought'] = shallowRef(null);
  readonly view: CourseEditorModel['view'] = shallowRef(null);
  readonly measure: CourseEditorModel['measure'] = shallowRef(null);
  readonly said = shallowRef('');
  readonly problem = shallowRef<SceneProblem | null>(null);
  readonly clipboard = new Clipboard();
  readonly pointer: CourseEditorModel['pointer'] = shallowRef(null);
  readonly menu: CourseEditorModel['menu'] = shallowRef(null);
  readonly words: CourseEditorModel['words'] = shallowRef(null);
  readonly runStart: CourseEditorModel['runStart'];
  readonly unfinished: WorkModel['unfinished'];
  readonly isOpen: ComputedRef<boolean>;
  readonly isWaiting: ComputedRef<boolean>;
  private parts: EditorParts | null = null;

  constructor(private readonly around: EditorSurroundings) {
    const { mode, work, runStart, isActive } = around;
    this.runStart = runStart;
    this.unfinished = work.unfinished;
    this.isOpen = computed(() => mode.current.value === 'build');
    this.tool = computed(() => {
      if (!this.isOpen.value) return 'hand';
      return this.chosen.value ?? (work.locks.hasTool('select') ? 'select' : 'hand');
    });
    this.isWaiting = computed(
      () => isActive.value && runStart.value !== null && waitsForStart(runStart.value, work.scene.value),
    );
  }

  readonly choose = (tool: ArenaTool): void => {
    if (this.around.work.locks.refusesTool(tool) || !this.isOpen.value) return;
    this.drag.value = null;
    this.measure.value = null;
    if (tool === this.tool.value) return;
    this.chosen.value = tool;
    if (tool !== 'select' && tool !== 'rotate' && tool !== 'points') this.selection.value = nothingSelected;
    this.tell({ type: 'tool', tool });
  };

  readonly setOptions = (part: Partial<ToolOptions>): void => {
    this.options.value = { ...this.options.value, ...part };
  };

  readonly select = (selection: Selection): void => {
    if (isSameSelection(selection, this.selection.value)) return;
    this.selection.value = selection;
    this.tell({ type: 'selected', selection, scene: this.around.work.scene.value });
  };

  readonly commit = (edit: SceneEdit, select?: Selection): boolean => {
    if (this.isShut()) return false;
    const done = this.apply(edit);
    if (this.problem.value === null && select !== undefined) this.selection.value = select;
    return done;
  };

  readonly apply = (part: SceneEdit): boolean => {
    const { work } = this.around;
    const edit = this.parts?.whole(work.scene.value, part) ?? part;
    this.problem.value = this.parts?.problemOf(work.scene.value, edit) ?? null;
    if (this.problem.value !== null) {
      this.tell({ type: 'problem', problem: this.problem.value });
      return false;
    }
    this.drag.value = null;
    return work.edit(edit);
  };

  /** True where nothing is built. While somebody looks back, the reason is shown. */
  private isShut(): boolean {
    return this.around.work.staysAsItIs() || !this.isOpen.value;
  }

  readonly undo = (): void => {
    this.drag.value = null;
    if (!this.isShut()) this.around.work.undo();
  };

  readonly redo = (): void => {
    this.drag.value = null;
    if (!this.isShut()) this.around.work.redo();
  };

  readonly join = (parts: EditorParts): void => {
    const isFirst = this.parts === null;
    this.parts = parts;
    // The tool for which they were loaded has already been chosen.
    if (isFirst && this.tool.value !== 'hand') this.tell({ type: 'tool', tool: this.tool.value });
  };

  /** Deselects what is not in a course. */
  forgetGone(scene: Scene): void {
    const { ids, robot } = this.selection.value;
    if (ids.length === 0) return;
    const all = new Set(scene.objects.map(({ id }) => id));
    const left = ids.filter((id) => all.has(id));
    if (left.length < ids.length) this.selection.value = { ids: left, robot };
  }

  /** Deselects everything, and drops what is under way. */
  letGo(): void {
    this.selection.value = nothingSelected;
    this.drag.value = null;
    this.measure.value = null;
    this.menu.value = null;
    this.words.value = null;
  }

  /** Starts afresh for another course. */
  reset(): void {
    this.letGo();
    this.problem.value = null;
  }

  /** Announces what happened. */
  readonly tell = (happened: Happened): void => {
    const words = this.parts?.wordsFor(happened) ?? '';
    // Screen readers repeat a text only if something in it differs.
    this.said.value = words === this.said.value && words !== '' ? `${words}\u00a0` : words;
  };
}

/** True if two selections are equal. */
export const isSameSelection = (one: Selection, other: Selection): boolean =>
  one.robot === other.robot && one.ids.length === other.ids.length && one.ids.every((id, at) => other.ids[at] === id);
