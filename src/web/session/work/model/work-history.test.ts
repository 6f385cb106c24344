import { describe, expect, it } from 'vitest';

import type { SceneEdit } from '#scene/edit';
import { defaultScene, type Scene, type SceneObject } from '#scene/scene';

import { WorkModel, type CourseStep } from './work-model';

const wall = (id: string): SceneObject => ({ type: 'wall', id, from: [0, 0], to: [100, 0], thickness: 10 });
const adding = (id: string): SceneEdit => ({ type: 'add', objects: [wall(id)] });
const work = (): WorkModel => {
  const project = { files: [{ name: 'main.py', text: 'mine' }], scene: defaultScene(), course: 'closed-line' };
  return new WorkModel({ project, open: 'main.py', previous: [] }, () => 0);
};
const idsOf = ({ scene }: WorkModel): string[] => scene.value.objects.map(({ id }) => id);

describe('the history of a course', () => {
  it('takes five walls back one by one, and builds them again', () => {
    const model = work();
    for (const id of ['a', 'b', 'c', 'd', 'e']) model.edit(adding(id));
    for (let step = 0; step < 5; step += 1) expect(model.undo()).toBe(true);
    expect(idsOf(model)).toEqual([]);
    expect([model.undo(), model.canUndo.value, model.canRedo.value]).toEqual([false, false, true]);
    for (let step = 0; step < 5; step += 1) model.redo();
    expect(idsOf(model)).toEqual(['a', 'b', 'c', 'd', 'e']);
  });

  it('gives up what was taken back once something else is done', () => {
    const model = work();
    model.edit(adding('a'));
    model.undo();
    model.edit(adding('b'));
    expect([model.canRedo.value, idsOf(model)]).toEqual([false, ['b']]);
  });

  it('takes up a history that was kept, but only where nothing has been done since', () => {
    const earlier = work();
    earlier.edit(adding('a'));
    const later = work();
    later.setScene(earlier.scene.value, null);
    later.takeUp({ ...earlier.history.value, present: later.scene.value });
    expect([later.undo(), idsOf(later)]).toEqual([true, []]);
    later.takeUp({ past: [], present: later.scene.value, future: [] });
    expect(later.canRedo.value).toBe(true);
  });

  it('tells of each step the edit itself, with its inverse and the course without it', () => {
    const model = work();
    const steps: CourseStep[] = [];
    const stop = model.onStep((step) => steps.push(step));
    model.edit(adding('a'));
    model.edit(adding('b'));
    model.undo();
    model.redo();
    model.undo();
    stop();
    model.redo();
    expect(steps.map(({ type }) => type)).toEqual(['edit', 'edit', 'undo', 'redo', 'undo']);
    for (const { step, without } of steps.slice(1)) {
      expect(step).toMatchObject({ edit: adding('b'), inverse: { type: 'remove', ids: ['b'] } });
      expect(without.objects).toEqual([wall('a')]);
    }
  });

  it('does not count what changes nothing', () => {
    const model = work();
    expect(model.edit({ type: 'remove', ids: ['nobody'] })).toBe(false);
    expect(model.canUndo.value).toBe(false);
  });

  it('leaves the program alone', () => {
    const model = work();
    model.edit(adding('a'));
    model.setText('main.py', 'new');
    model.undo();
    expect(model.open.value.text).toBe('new');
  });

  it('begins anew with another course, after putting the old work aside', () => {
    const model = work();
    model.edit(adding('a'));
    const other: Scene = { ...defaultScene(), name: 'Other' };
    model.setScene(other, null, 'before');
    expect([model.canUndo.value, model.openings.value]).toEqual([false, 1]);
    expect(model.work.value.previous[0]?.project.scene.objects).toEqual([wall('a')]);
  });

  it('goes on when only the program is another one', () => {
    const model = work();
    model.edit(adding('a'));
    model.openProject({ ...model.work.value.project, files: [{ name: 'main.py', text: 'example' }] }, null);
    expect([model.canUndo.value, model.openings.value]).toEqual([true, 0]);
  });

  it('lets a ready course keep its name until somebody calls it otherwise', () => {
    const model = work();
    model.edit(adding('a'));
    expect(model.work.value.project.course).toBe('closed-line');
    model.edit({ type: 'course', changes: { name: 'My course' } });
    expect(model.work.value.project.course).toBeNull();
    model.undo();
    expect(model.work.value.project.course).toBe('closed-line');
  });
});
