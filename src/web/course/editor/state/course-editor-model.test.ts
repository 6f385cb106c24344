import { describe, expect, it } from 'vitest';
import { effectScope, nextTick, shallowRef } from 'vue';

import { defaultScene, type Scene, type SceneObject } from '#scene/scene';

import { defaultSettings } from '../../../session/work/settings/settings';
import { createCourseEditor, type Happened } from './course-editor-model';
import type { LayoutKind } from '../../../session/layout/layout-model';
import type { SettingsModel } from '../../../session/work/settings/settings-model';
import { WorkModel, type CourseStep } from '../../../session/work/model/work-model';

const wall = (id: string): SceneObject => ({ type: 'wall', id, from: [0, 0], to: [100, 0], thickness: 10 });

function editing(kind: LayoutKind = 'wide') {
  const project = { files: [{ name: 'main.py', text: '' }], scene: defaultScene(), course: null };
  const work = new WorkModel({ project, open: 'main.py', previous: [] }, () => 0);
  const current = shallowRef(defaultSettings('de'));
  const change: SettingsModel['change'] = (part) => void (current.value = { ...current.value, ...part });
  const settings: SettingsModel = { current, own: current, change, bring: change, hold: change };
  const edits: CourseStep[] = [];
  work.onStep((step) => edits.push(step));
  const past = shallowRef<unknown>(null);
  const scope = effectScope();
  const editor = scope.run(() =>
    createCourseEditor({
      work,
      settings,
      kind: shallowRef(kind),
      runStart: shallowRef<Scene | null>(null),
      isActive: shallowRef(false),
      past,
    }),
  )!;
  return { work, editor, edits, past };
}

describe('the course editor', () => {
  it('does an edit as one step, selects what it made and says it', () => {
    const { work, editor, edits } = editing();
    const heard: Happened[] = [];
    editor.join({ problemOf: () => null, wordsFor: (happened) => (heard.push(happened), happened.type) });
    editor.choose('select');
    expect(editor.commit({ type: 'add', objects: [wall('a')] }, { ids: ['a'], robot: false })).toBe(true);
    expect([work.canUndo.value, editor.selection.value.ids, edits.length]).toEqual([true, ['a'], 1]);
    expect(heard.map(({ type }) => type)).toEqual(['tool', 'edit']);
    expect(editor.said.value).toBe('edit');
  });

  it('is the hand while somebody looks back; the tool comes back with the present', () => {
    const { editor, past } = editing();
    editor.choose('pen');
    past.value = {};
    expect(editor.tool.value).toBe('hand');
    editor.choose('block');
    past.value = null;
    expect(editor.tool.value).toBe('pen');
  });

  it('says the same words again so that they are heard again', () => {
    const { editor } = editing();
    editor.join({ problemOf: () => null, wordsFor: () => 'wall' });
    editor.commit({ type: 'add', objects: [wall('a')] });
    const first = editor.said.value;
    editor.commit({ type: 'add', objects: [wall('b')] });
    expect(editor.said.value).not.toBe(first);
    expect(editor.said.value.trim()).toBe(first);
  });

  it('refuses what goes beyond the limits and changes nothing', () => {
    const { work, editor } = editing();
    const problem = { code: 'too-many', path: '', value: '', params: {}, message: '' } as const;
    editor.join({ problemOf: () => problem, wordsFor: () => '' });
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

  it('takes the hand when the tools are folded away', async () => {
    const { editor } = editing();
    editor.choose('pen');
    editor.setOpen(false);
    await nextTick();
    expect([editor.isOpen.value, editor.tool.value]).toEqual([false, 'hand']);
  });

  it('shows its tools from the first, but not on a phone', () => {
    expect(editing('narrow').editor.isOpen.value).toBe(true);
    const { editor } = editing('phone');
    expect(editor.isOpen.value).toBe(false);
    editor.setOpen(true);
    expect(editor.isOpen.value).toBe(true);
  });
});
