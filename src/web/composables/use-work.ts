import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import type { Scene } from '#scene/scene';

import { putAside, type Previous, type Work } from '../project/history';
import { freeName, MAIN, type Project, type SourceFile } from '../project/project';

/** The pupil's work: files, the one that is shown, the course, and what was put aside. All changes go through here. */
export class WorkModel {
  readonly work: ShallowRef<Work>;
  readonly files: ComputedRef<readonly SourceFile[]>;
  readonly scene: ComputedRef<Scene>;
  readonly open: ComputedRef<SourceFile>;

  constructor(
    work: Work,
    private readonly nowMs: () => number,
  ) {
    this.work = shallowRef(work);
    this.files = computed(() => this.work.value.project.files);
    this.scene = computed(() => this.work.value.project.scene);
    this.open = computed(() => this.find(this.work.value.open) ?? { name: MAIN, text: '' });
  }

  find(name: string): SourceFile | undefined {
    return this.files.value.find((file) => file.name === name);
  }

  show(name: string): void {
    if (this.find(name) !== undefined) this.work.value = { ...this.work.value, open: name };
  }

  setText(name: string, text: string): void {
    this.setFiles(this.files.value.map((file) => (file.name === name ? { name, text } : file)));
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

  /** Takes a loaded file in under a name that is free; never over another one. Returns the name. */
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

  /** Only the course changes; the files stay. */
  setScene(scene: Scene, course: string | null): void {
    this.work.value = { ...this.work.value, project: { ...this.work.value.project, scene, course } };
  }

  /** Opens another project; the work so far is put aside when `nameOfOld` is given. */
  openProject(project: Project, nameOfOld: string | null): void {
    if (nameOfOld !== null) this.keep(nameOfOld);
    this.work.value = { ...this.work.value, project, open: MAIN };
  }

  /** Brings a piece of earlier work back and puts the present one in its place. */
  restore(entry: Previous, nameOfOld: string): void {
    const rest = this.work.value.previous.filter((other) => other !== entry);
    this.work.value = { ...this.work.value, previous: rest };
    this.openProject(entry.project, nameOfOld);
  }

  private keep(name: string): void {
    const { project, previous } = this.work.value;
    this.work.value = { ...this.work.value, previous: putAside(previous, project, name, this.nowMs()) };
  }

  private setFiles(files: readonly SourceFile[], open = this.work.value.open): void {
    this.work.value = { ...this.work.value, open, project: { ...this.work.value.project, files } };
  }
}
