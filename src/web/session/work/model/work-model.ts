import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import {
  addedDevice,
  deviceNames,
  filesOfDevice,
  furtherDevice,
  placeOfFiles,
  putBackDevice,
  removedDevice,
  renamedDevice,
  withDevice,
  withFiles,
} from '#project/devices';
import { freeName, MAIN, type Carried, type FurtherDevice, type Project, type SourceFile } from '#project/project';
import type { Stop } from '#core/stop';
import type { SceneEdit } from '#scene/edit';
import { advanced, historyOf, redone, undone, type History, type Step } from '#scene/history';
import type { Scene } from '#scene/scene';

import type { Unsaved } from './unsaved';
import { withoutHandedOut, WorkLocks } from './task-locks';
import { putAside, type Deleted, type Previous, type Work } from '../storage/history';
import { withDeleted, withoutDeleted } from './deleted-works';

/** A step of the course that was just done, taken back, or done again. */
export interface CourseStep {
  readonly type: 'edit' | 'undo' | 'redo';
  readonly step: Step;
  /** The course without the step: before it was done, after it was taken back. */
  readonly without: Scene;
}

/**
 * The pupil's work: files, the shown file, the course with its undo history, and the work that was put aside. All
 * changes go through here.
 */
export class WorkModel {
  readonly work: ShallowRef<Work>;
  /** Place of the device that is shown: whose files, board and console. */
  readonly place: ShallowRef<number> = shallowRef(0);
  /** The names of all devices; of a project with one, one that nobody reads. */
  readonly devices: ComputedRef<readonly string[]>;
  readonly hasSeveral: ComputedRef<boolean>;
  /** The files of the device that is shown. */
  readonly files: ComputedRef<readonly SourceFile[]>;
  readonly scene: ComputedRef<Scene>;
  readonly open: ComputedRef<SourceFile>;
  /** Counts the opened courses: each is a new start, with nothing to undo. */
  readonly openings: ShallowRef<number> = shallowRef(0);
  /** Counts the opened works, be it another program in the course that is open. */
  readonly works: ShallowRef<number> = shallowRef(0);
  /** Counts what came with an address, be it the course that is open already. */
  readonly arrivals: ShallowRef<number> = shallowRef(0);
  readonly canUndo: ComputedRef<boolean>;
  readonly canRedo: ComputedRef<boolean>;
  /** The present work was brought by a host or by the address, with what they hold for it. */
  isBrought = false;
  /** The edit that a gesture still under way in the arena amounts to; `null` without one. It is saved with the work. */
  readonly unfinished: ShallowRef<(() => Scene | null) | null> = shallowRef(null);
  /** The reason why the work is stored nowhere; `null`: it is stored. */
  readonly unsaved: ShallowRef<Unsaved | null> = shallowRef(null);
  readonly locks = new WorkLocks();
  /** The store of the pupil's programs for ready courses (`own-programs.ts`); `null`: none. */
  programs: Storage | null = null;
  /** True if course and devices must not change just now; the answer comes with a notice to the pupil. */
  staysAsItIs: () => boolean = () => false;
  /** The course with its undo history. */
  readonly history: ShallowRef<History>;
  private readonly listeners = new Set<(step: CourseStep) => void>();
  /** The opened project. If the name or description of its course changes, it is no longer a ready course. */
  private origin: Project;

  constructor(
    work: Work,
    private readonly nowMs: () => number,
  ) {
    this.work = shallowRef(work);
    this.history = shallowRef(historyOf(work.project.scene));
    this.origin = work.project;
    this.canUndo = computed(() => this.history.value.past.length > 0);
    this.canRedo = computed(() => this.history.value.future.length > 0);
    this.devices = computed(() => deviceNames(this.work.value.project));
    this.hasSeveral = computed(() => this.devices.value.length > 1);
    this.files = computed(() => filesOfDevice(this.work.value.project, this.place.value));
    this.scene = computed(() => this.work.value.project.scene);
    this.open = computed(() => this.find(this.work.value.open) ?? { name: MAIN, text: '' });
  }

  /** The work as it would be if the gesture ended now. */
  withUnfinished(): Work {
    const work = this.work.value;
    const scene = this.unfinished.value?.() ?? work.project.scene;
    return scene === work.project.scene ? work : { ...work, project: { ...work.project, scene } };
  }

  /** Shows another device, with the file of it that was open last. */
  showDevice(place: number): void {
    if (place === this.place.value || this.devices.value[place] === undefined) return;
    const { project } = this.work.value;
    this.opened.set(placeOfFiles(project, this.place.value), this.work.value.open);
    const open = this.opened.get(placeOfFiles(project, place)) ?? MAIN;
    this.place.value = place;
    this.work.value = { ...this.work.value, open: this.find(open) === undefined ? MAIN : open };
  }
  /** The file that was open last, by the place of the device that has it. */
  private readonly opened = new Map<number, string>();

  /** Number of times that somebody wished for one more device: what it shall be is asked elsewhere. */
  readonly deviceWishes = shallowRef(0);
  wishDevice(): void {
    if (!this.staysAsItIs()) this.deviceWishes.value += 1;
  }

  /** Adds a device and shows it. @param first what the first one is called if it was alone */
  addDevice(device: FurtherDevice, first: string): void {
    if (this.staysAsItIs()) return;
    this.setProject(addedDevice(this.work.value.project, device, first));
    this.showDevice(this.devices.value.length - 1);
  }

  /** Takes a further device away. The whole work is put aside if `nameOfOld` is given. Returns whether that was done. */
  removeDevice(place: number, nameOfOld: string | null): boolean {
    const before = this.work.value.project;
    if (furtherDevice(before, place) === null || this.staysAsItIs()) return false;
    const project = this.locks.changed(before, removedDevice(before, place), false);
    if (project === null) return false;
    if (nameOfOld !== null) this.keep(nameOfOld);
    const shown = this.place.value;
    this.showDevice(0);
    this.opened.clear();
    this.work.value = { ...this.work.value, project };
    if (shown !== place) this.showDevice(shown > place ? shown - 1 : shown);
    return true;
  }

  /** Puts a device that was taken away back into its place, and shows it. @param first what the first one was called */
  putDeviceBack(device: FurtherDevice, place: number, first: string): void {
    if (this.staysAsItIs()) return;
    this.opened.clear();
    this.setProject(putBackDevice(this.work.value.project, device, place, first));
    this.showDevice(place);
  }

  renameDevice(place: number, name: string): void {
    if (this.staysAsItIs()) return;
    this.setProject(renamedDevice(this.work.value.project, place, name));
  }

  /** Changes what a further device is made of. */
  changeDevice(place: number, change: Partial<FurtherDevice>): void {
    if (this.staysAsItIs()) return;
    this.setProject(withDevice(this.work.value.project, place, change));
    if (this.find(this.work.value.open) === undefined) this.show(MAIN);
  }

  find(name: string): SourceFile | undefined {
    return this.files.value.find((file) => file.name === name);
  }

  show(name: string): void {
    if (this.find(name) !== undefined) this.work.value = { ...this.work.value, open: name };
  }

  /** @param isTyped in the page's editor, not brought from elsewhere */
  setText(name: string, text: string, isTyped = false): void {
    const files = this.files.value.map((file) => (file.name === name ? { name, text } : file));
    this.setFiles(files, this.work.value.open, isTyped);
  }

  /** Adds a file and shows it; its name must be free. */
  create(name: string, text = ''): void {
    this.setFiles([...this.files.value, { name, text }], name);
  }

  rename(from: string, to: string): void {
    if (from === MAIN) return;
    const open = this.work.value.open === from ? to : this.work.value.open;
    this.setFiles(
      this.files.value.map((file) => (file.name === from ? { name: to, text: file.text } : file)),
      open,
    );
  }

  remove(name: string): void {
    if (name === MAIN) return;
    const index = this.files.value.findIndex((file) => file.name === name);
    const open = this.work.value.open === name ? this.files.value[index - 1]?.name : this.work.value.open;
    this.setFiles(
      this.files.value.filter((file) => file.name !== name),
      open,
    );
  }

  /** Puts a file that was removed from a device back into its place, and shows it. */
  putBack(device: number, file: SourceFile, at: number): void {
    const { project } = this.work.value;
    this.setProject(withFiles(project, device, filesOfDevice(project, device).toSpliced(at, 0, file)));
    if (device === this.place.value) this.show(file.name);
  }

  /** Adds a loaded file under a free name, never over another file. Returns the name. */
  takeIn(file: SourceFile): string {
    const name = this.find(file.name) === undefined ? file.name : freeName(file.name, this.files.value);
    this.create(name, file.text);
    return name;
  }

  /** Replaces a file's text after putting the whole work aside. */
  replace(file: SourceFile, nameOfOld: string): void {
    this.keep(nameOfOld);
    this.setText(file.name, file.text);
    this.show(file.name);
  }

  /** Changes the course; one step that can be taken back. Returns whether anything changed. */
  edit(edit: SceneEdit): boolean {
    const history = advanced(this.history.value, edit);
    return this.go('edit', history, history.past.at(-1));
  }

  /** Takes the last change of the course back. Returns whether there was one. */
  undo(): boolean {
    const history = undone(this.history.value);
    return this.go('undo', history, history.future[0]);
  }

  /** Redoes what was last taken back. Returns whether there was anything. */
  redo(): boolean {
    const history = redone(this.history.value);
    return this.go('redo', history, history.past.at(-1));
  }

  /** Calls the listener after each step. Opening another course is not a step. */
  onStep(listener: (step: CourseStep) => void): Stop {
    this.listeners.add(listener);
    return () => void this.listeners.delete(listener);
  }

  /** Restores a stored undo history, unless the course has changed since. */
  takeUp(kept: History): void {
    const { past, present, future } = this.history.value;
    if (past.length + future.length === 0 && present === kept.present) this.history.value = kept;
  }

  /** Opens another course; the files stay. The work so far is put aside if `nameOfOld` is given. */
  setScene(scene: Scene, course: string | null, nameOfOld: string | null = null): void {
    this.put({ ...withoutHandedOut(this.work.value.project), scene, course }, this.work.value.open, nameOfOld);
  }

  /** Opens another project, perhaps from a file. The work so far is put aside if `nameOfOld` is given. */
  openProject(project: Project, nameOfOld: string | null, file?: string): void {
    this.place.value = 0;
    this.opened.clear();
    this.put(project, MAIN, nameOfOld, file);
  }

  /** Brings a piece of earlier work back and puts the present one in its place. */
  restore(entry: Previous, nameOfOld: string): void {
    const rest = this.work.value.previous.filter((other) => other !== entry);
    this.work.value = { ...this.work.value, previous: rest };
    this.openProject(entry.project, nameOfOld, entry.file);
  }

  /** Deletes earlier works; for some time they can be brought back. */
  deleteWorks(entries: readonly Previous[]): readonly Deleted[] {
    const deleted = entries.map((entry): Deleted => ({ ...entry, deletedMs: this.nowMs() }));
    this.work.value = withDeleted(this.work.value, entries, deleted, this.nowMs());
    return deleted;
  }

  /** Puts deleted works back among the earlier ones. */
  bringBack(deleted: readonly Deleted[]): void {
    this.work.value = withoutDeleted(this.work.value, deleted);
  }

  /** Forgets everything that was deleted, to make room. */
  forgetDeleted(): void {
    const { deleted: _, ...work } = this.work.value;
    this.work.value = work;
  }

  private put(project: Project, open: string, nameOfOld: string | null, file?: string): void {
    if (nameOfOld !== null) this.keep(nameOfOld);
    this.works.value += 1;
    // Another program in the same course takes nothing from its history.
    if (this.history.value.present !== project.scene) {
      this.history.value = historyOf(project.scene);
      this.origin = project;
      // Told first: a run of the old course must be over before it hears of the new one.
      this.openings.value += 1;
    }
    const { file: _, isHandedIn: __, ...work } = this.work.value;
    this.work.value = { ...work, project, open, ...(file !== undefined && { file }) };
  }

  private go(type: CourseStep['type'], history: History, step: Step | undefined): boolean {
    const before = this.history.value;
    if (history === before || !step || this.staysAsItIs()) return false;
    if (this.locks.refusesStep(type, step)) return false;
    const { present } = history;
    this.history.value = history;
    const { course, scene } = this.origin;
    const isCalledSo = present.name === scene.name && present.description === scene.description;
    const project = { ...this.work.value.project, scene: present, course: isCalledSo ? course : null };
    this.work.value = { ...this.work.value, project };
    const without = type === 'undo' ? present : before.present;
    for (const listener of this.listeners) listener({ type, step, without });
    return true;
  }

  private keep(name: string): void {
    const { project, file, previous } = this.work.value;
    const entry = { name, atMs: this.nowMs(), project, ...(file !== undefined && { file }) };
    this.work.value = { ...this.work.value, previous: putAside(previous, entry) };
  }

  private setFiles(files: readonly SourceFile[], open = this.work.value.open, isTyped = false): void {
    this.setProject(withFiles(this.work.value.project, this.place.value, files), open, isTyped);
  }

  /** Sets the task for a class (`#check/task`); `null`: none. */
  setTask(task: Carried | null): void {
    const { task: _, ...project } = this.work.value.project;
    this.setProject(task === null ? project : { ...project, task });
  }

  /** Sets the pupil's additions to the hand-in (`#check/hand-in`). */
  setHandIn(handIn: Carried): void {
    this.work.value = { ...this.work.value, project: { ...this.work.value.project, handIn } };
  }

  /** Notes that the open work has been handed in. */
  noteHandedIn(): void {
    this.work.value = { ...this.work.value, isHandedIn: true };
  }

  private setProject(wished: Project, open = this.work.value.open, isTyped = false): void {
    const { locks, work } = this;
    const project = locks.changed(work.value.project, wished, isTyped);
    if (project !== null) work.value = { ...work.value, open, project };
  }
}
