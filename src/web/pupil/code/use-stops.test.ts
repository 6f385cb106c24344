// @vitest-environment happy-dom
import { EditorView, runScopeHandlers } from '@codemirror/view';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, h, onMounted, shallowRef } from 'vue';

import { mountOn } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { useStops } from './use-stops';

/** A page with an editor that has nothing but the column of break points. */
function editorOn(page: ReturnType<typeof createPage>): EditorView {
  const view = shallowRef<EditorView | null>(null);
  const Editor = defineComponent(() => {
    const { column } = useStops(page, view);
    onMounted(() => (view.value = new EditorView({ doc: page.work.open.value.text, extensions: column })));
    return () => h('div');
  });
  mountOn(page, Editor);
  if (view.value === null) throw new Error('There is no editor.');
  return view.value;
}

beforeEach(() => sessionStorage.clear());

describe('a break point set with F9', () => {
  it('is in the file that was shown then, also when another one is shown before the debugger has come', async () => {
    const page = createPage();
    const editor = editorOn(page);
    runScopeHandlers(editor, new KeyboardEvent('keydown', { key: 'F9' }), 'editor');
    page.work.create('other.py', 'x = 1\n');
    await vi.dynamicImportSettled();
    expect(page.slot.debug.value?.points.lines.value).toEqual({ '1/main.py': [1] });
  });
});
