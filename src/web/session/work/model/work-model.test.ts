import { describe, expect, it } from 'vitest';

import type { Project } from '#project/project';
import { defaultScene } from '#scene/scene';

import { WorkModel } from './work-model';

const project = (text: string): Project => ({
  files: [{ name: 'main.py', text }],
  scene: defaultScene(),
  course: null,
});
const model = (text = 'mine'): WorkModel =>
  new WorkModel({ project: project(text), open: 'main.py', previous: [] }, () => 1000);
const names = (work: WorkModel): string[] => work.files.value.map((file) => file.name);

describe('the pupil’s work', () => {
  it('shows a new file at once', () => {
    const work = model();
    work.create('drive.py');
    expect(names(work)).toEqual(['main.py', 'drive.py']);
    expect(work.open.value.name).toBe('drive.py');
  });

  it('never deletes or renames main.py', () => {
    const work = model();
    work.remove('main.py');
    work.rename('main.py', 'other.py');
    expect(names(work)).toEqual(['main.py']);
  });

  it('shows the file before the deleted one', () => {
    const work = model();
    work.create('a.py');
    work.create('b.py');
    work.remove('b.py');
    expect(work.open.value.name).toBe('a.py');
  });

  it('stays with a file that is renamed', () => {
    const work = model();
    work.create('a.py', 'text');
    work.rename('a.py', 'b.py');
    expect(work.open.value).toEqual({ name: 'b.py', text: 'text' });
  });

  it('takes a loaded file in beside the one of the same name', () => {
    const work = model();
    expect(work.takeIn({ name: 'main.py', text: 'loaded' })).toBe('main2.py');
    expect(work.find('main.py')?.text).toBe('mine');
  });

  it('puts everything aside before a file is replaced', () => {
    const work = model();
    work.replace({ name: 'main.py', text: 'loaded' }, 'before');
    expect(work.open.value.text).toBe('loaded');
    expect(work.work.value.previous).toEqual([{ name: 'before', atMs: 1000, project: project('mine') }]);
  });

  it('brings earlier work back and puts the present one in its place', () => {
    const work = model();
    work.openProject(project('course'), 'mine');
    const [earlier] = work.work.value.previous;
    work.restore(earlier!, 'course');
    expect(work.open.value.text).toBe('mine');
    expect(work.work.value.previous.map((entry) => entry.project.files[0]!.text)).toEqual(['course']);
  });

  it('changes the course and leaves the files alone', () => {
    const work = model();
    work.setScene({ ...defaultScene(), name: 'Line' }, 'closed-line');
    expect(work.scene.value.name).toBe('Line');
    expect(work.open.value.text).toBe('mine');
  });
});
