import type { Extension } from '@codemirror/state';
import { computed, effectScope, watch } from 'vue';

import type { SaidRemark } from '#check/hand-in/hand-in';
import { courseMark } from '#check/task/course-mark';
import { keptLines } from '#check/task/kept-lines';
import { locksOf } from '#check/task/read-task';
import { noLocks, type LockName, type Locks } from '#check/task/task';
import { isSame } from '#core/same';
import type { Stop } from '#core/stop';
import { MAIN, type Project } from '#project/project';
import type { Step } from '#scene/history';
import type { InputAction } from '#simulation/input';

import { lockedText } from '../code/locked-text';
import type { CourseEditorParts } from '../../course/editor/state/parts';
import type { PageParts } from '../../kit/parts';
import { t } from '../../kit/i18n';
import type { RunParts } from '../../session/run/parts';
import { isHandedOut, type TaskLocks } from '../../session/work/model/task-locks';
import type { WorkParts } from '../../session/work/model/parts';
import { filesByDevice } from '../../session/work/programs/own-programs';
import words from './words';
import { closedByExam, examRefuses, holdExam, type ExamPage } from './hold-exam';
import { mainText } from './main-text';
import { holdLockedSettings, OF_THE_ROBOT } from './hold-locked-settings';
import { lockedLines } from './locked-lines';
import { followLocks } from './follow-locks';
import { bringsText, withOutsideRemark, isFromOutside } from './outside';
import { removeLockedOffers } from './remove-locked-offers';
import { takeBack } from './since-opening';
import { UsedHand } from './used-hand';
import { watchLargePastes } from './watch-large-pastes';
import { isMadeWith } from './with-tools';

/** The actions on a run that are the hand's. */
const BY_HAND: readonly InputAction['type'][] = ['place', 'place-block', 'sensor', 'switch'];

/** The models that locks need. */
export type LockedPage = Pick<PageParts, 'notices' | 'late'> &
  WorkParts &
  Pick<RunParts, 'run' | 'sensors' | 'hand'> &
  Pick<CourseEditorParts, 'editor' | 'panels'> &
  ExamPage;

/**
 * Enforces the locks of a task that was handed out, while it is open; in the teacher's own task, keeps the locks on
 * their lines.
 */
export const lockTask = (app: LockedPage, opened: Project): Stop =>
  isHandedOut(opened) ? lockGiven(app, opened) : followLocks(app);

function lockGiven(app: LockedPage, opened: Project): Stop {
  takeBack(app, opened);
  const scope = effectScope(true);
  scope.run(() => {
    const task = new OpenTaskLocks(app);
    app.work.locks.task.value = task;
    lockedText(app).value = (file) => task.inEditor(file);
    beginWith(app, task);
    holdExam(app);
  });
  return () => {
    app.work.locks.task.value = null;
    lockedText(app).value = null;
    scope.stop();
  };
}

/** Puts back the choices that the task locks. */
function beginWith(app: LockedPage, task: OpenTaskLocks): void {
  const { editor, sensors, hand } = app;
  watch(
    [() => task.locks, app.work.openings],
    ([locks]) => {
      if (!task.hasTool(editor.tool.value)) editor.choose('hand');
      if (!locks.hand) return;
      sensors.reset(new Map());
      hand.reset();
    },
    { immediate: true },
  );
  watch(
    app.panels.shown,
    (panel) => {
      // They build; a picture for the floor opens one, too.
      if (panel !== null && panel !== 'print' && task.refusesTool('select')) app.panels.close();
    },
    { immediate: true, flush: 'sync' },
  );
  holdLockedSettings(app, task);
  removeLockedOffers(app, task);
}

class OpenTaskLocks implements TaskLocks {
  private readonly current = computed((before?: Locks) => {
    const { task } = this.app.work.work.value.project;
    const locks = task === undefined || !isHandedOut({ task }) ? noLocks : locksOf(task);
    return before !== undefined && isSame(before, locks) ? before : locks;
  });

  /** The use of the hand in the last run. */
  private readonly hand: UsedHand;
  private readonly copied = { text: '' };

  constructor(private readonly app: LockedPage) {
    this.hand = new UsedHand(app);
  }

  get locks(): Locks {
    return this.current.value;
  }

  refuses(what: LockName): boolean {
    const isLocked = Boolean(this.locks[what]);
    if (isLocked) this.tell(t(words[what]));
    return isLocked;
  }

  noticed(): readonly SaidRemark[] {
    const { project } = this.app.work.work.value;
    const course = project.task?.['course'];
    return [
      ...(course !== undefined && course !== courseMark(project.scene) ? (['course'] as const) : []),
      ...(this.hand.isUsed ? (['hand'] as const) : []),
      ...(isFromOutside(project) ? (['outside'] as const) : []),
    ];
  }

  hasTool(tool: string): boolean {
    const { course, tools } = this.locks;
    if (tool === 'hand') return true;
    // Points are bent in the course of selecting.
    return (!course || tool === 'ruler') && (tools?.includes(tool === 'points' ? 'select' : tool) ?? true);
  }

  refusesTool(tool: string): boolean {
    if (this.hasTool(tool)) return false;
    this.tell(t(this.locks.course ? words.course : words.tools));
    return true;
  }

  refusesStep(type: 'edit' | 'undo' | 'redo', { edit }: Pick<Step, 'edit'>): boolean {
    if (this.refuses('course')) return true;
    if (this.locks.tools === null || type !== 'edit') return false;
    const isRefused = !isMadeWith((tool) => this.hasTool(tool), this.app.work.scene.value, edit);
    if (isRefused) this.tell(t(words.tools));
    return isRefused;
  }

  refusesInput(action: InputAction): boolean {
    if (BY_HAND.includes(action.type) && this.refuses('hand')) return true;
    this.hand.does(action);
    return false;
  }

  refusesSettings(names: readonly string[]): boolean {
    return (
      (names.some((name) => OF_THE_ROBOT.some((one) => one === name)) && this.refuses('robot')) ||
      (names.includes('speed') && this.refuses('speed')) ||
      (names.includes('arenaSenses') && this.refuses('hand'))
    );
  }

  changed(before: Project, wished: Project, isTyped: boolean): Project | null {
    // Whoever begins anew has no task any more.
    if (wished.task !== before.task) {
      if (wished.task !== undefined) this.tell(t(words.given));
      return wished.task === undefined ? wished : null;
    }
    const closed = isSame(filesByDevice(before), filesByDevice(wished)) ? null : examRefuses(this.app);
    if (closed !== null) {
      this.tell(closed);
      return null;
    }
    const after = !isTyped && bringsText(before, wished) ? withOutsideRemark(wished) : wished;
    if (!isSame(hardwareOf(before), hardwareOf(after)) && this.refuses('robot')) return null;
    return this.withLines(before, after);
  }

  inEditor(file: string): Extension {
    const { work } = this.app;
    const pasted = watchLargePastes(this.copied, () => {
      const { handIn } = withOutsideRemark(work.work.value.project);
      if (handIn !== undefined) work.setHandIn(handIn);
    });
    const closed = closedByExam(this.app, (text) => this.tell(text));
    const isStart = file === MAIN && work.place.value === 0;
    if (!isStart || this.locks.lines.length === 0) return [pasted, closed];
    const refuse = (): void => this.tell(t(words.lines));
    return [pasted, closed, lockedLines(() => this.locks.lines, t(words.line), refuse)];
  }

  /** Stores the places of the locked lines with the work, so that they survive a reload. */
  private withLines(before: Project, after: Project): Project | null {
    const { task } = after;
    const { lines } = this.locks;
    if (task === undefined || lines.length === 0 || mainText(before) === mainText(after)) return after;
    const kept = keptLines(mainText(before), mainText(after), lines);
    if (kept === null) this.tell(t(words.lines));
    if (kept === null || isSame(kept, lines)) return kept && after;
    return { ...after, task: { ...task, locks: { ...(task['locks'] as object), lines: kept } } };
  }

  private tell(text: string): void {
    this.app.notices.show({ kind: 'info', key: 'notice.text', values: { text } });
  }
}

/** The further devices without their programs and names. */
const hardwareOf = ({ devices }: Project): unknown =>
  (devices?.others ?? []).map(({ name: _, files: __, ...hardware }) => hardware);
