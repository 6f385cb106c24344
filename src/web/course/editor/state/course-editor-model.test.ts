import type { SceneEdit } from '#scene/edit';
import { describe, expect, it } from 'vitest';
import { computed, effectScope, nextTick, shallowRef } from 'vue';

import { defaultScene, type Scene, type SceneObject } from '#scene/scene';

import { createCourseEditor, type Happened } from './course-editor-model';
import type { ArenaMode } from '../../../session/mode/mode-model';
import { WorkModel, type CourseStep } from '../../../session/work/model/work-model';

const wall = (id: string): SceneObject => ({ type: 'wall', id, from: [0, 0], to: [100, 0], thickness: 10 });

function editing() {
  const project = { files: [{ name: 'main.py', text: '' }], scene: defaultScene(), course: null };
  const work = new WorkModel({ project, open: 'main.py', previous: [] }, () => 0);
  const mode = shallowRef<ArenaMode>('build');
  const edits: CourseStep[] = [];
  work.onStep((step) => edits.push(step));
  const scope = effectScope();
  const editor = scope.run(() =>
    createCourseEditor({
      work,
      mode: { current: computed(() => mode.value) },
      runStart: shallowRef<Scene | null>(null),
      isActive: shallowRef(false),
    }),
  )!;
  return { work, editor, edits, mode };
}

/** Nothing goes along. */
const whole = (_: unknown, edit: SceneEdit): SceneEdit => edit;

describe('the course editor', () => {
  it('does an edit as one step, selects what it made and says it', () => {
    const { work, editor, edits } = editing();
    const heard: Happened[] = [];
    editor.join({ problemOf: () => null, whole, wordsFor: (happened) => (heard.push(happened), happened.type) });
    editor.choose('rotate');
    expect(editor.commit({ type: 'add', objects: [wall('a')] }, { ids: ['a'], robot: false })).toBe(true);
    expect([work.canUndo.value, editor.selection.value.ids, edits.length]).toEqual([true, ['a'], 1]);
    expect(heard.map(({ type }) => type)).toEqual(['tool', 'tool', 'edit']);
    expect(editor.said.value).toBe('edit');
  });

  it('begins with selecting', () => expect(editing().editor.tool.value).toBe('select'));

  it.each(['drive', 'lookBack'] as const)('is the hand in %s; the tool comes back with building', (other) => {
    const { editor, mode } = editing();
    editor.choose('pen');
    mode.value = other;
    expect([editor.isOpen.value, editor.tool.value]).toEqual([false, 'hand']);
    editor.choose('block');
    mode.value = 'build';
    expect(editor.tool.value).toBe('pen');
  });

  it('lets go of what is selected when nothing is built any more', async () => {
    const { editor, mode } = editing();
    editor.commit({ type: 'add', objects: [wall('a')] }, { ids: ['a'], robot: false });
    mode.value = 'drive';
    await nextTick();
    expect(editor.selection.value.ids).toEqual([]);
  });

  it('takes along what an edit takes along, in one step to undo', () => {
    const { work, editor } = editing();
    const both = { type: 'add', objects: [wall('a'), wall('b')] } as const;
    editor.join({ problemOf: () => null, whole: () => both, wordsFor: () => '' });
    editor.commit({ type: 'add', objects: [wall('a')] });
    expect(work.scene.value.objects).toHaveLength(2);
    editor.undo();
    expect(work.scene.value.objects).toEqual([]);
  });

  it('says the same words again so that they are heard again', () => {
    const { editor } = editing();
    editor.choose('hand');
    editor.join({ problemOf: () => null, whole, wordsFor: () => 'wall' });
    editor.commit({ type: 'add', objects: [wall('a')] });
    const first = editor.said.value;
    editor.commit({ type: 'add', objects: [wall('b')] });
    expect(editor.said.value).not.toBe(first);
    expect(editor.said.value.trim()).toBe(first);
  });

  it('refuses what goes beyond the limits and changes nothing', () => {
    const { work, editor } = editing();
    const problem = { code: 'too-many', path: '', value: '', params: {}, message: '' } as const;
    editor.join({ problemOf: () => problem, whole, wordsFor: () => '' });
    expect(editor.commit({ type: 'add', objects: [wall('a')] })).toBe(false);
    expect([work.scene.value.objects, editor.problem.value]).toEqual([[], problem]);
  });

  it('does not keep selected what undo has taken away', () => {
    const { editor } = editing();
    editor.choose('select');
    editor.commit({ type: 'add', objects: [wall('a')] }, { ids: ['a'], robot: true });
    editor.undo();
    expect(editor.selection.value).toEqual({ ids: [], robot: true });
  });
});
