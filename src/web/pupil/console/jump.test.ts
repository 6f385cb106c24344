// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';

import { createPage } from '../../app/testing/page';

describe('the wish to see a line', () => {
  it('shows its file', () => {
    const { work, jump } = createPage();
    const files = ['main.py', 'helfer.py'].map((name) => ({ name, text: '' }));
    work.openProject({ files, scene: work.scene.value, course: null }, null);
    jump.to({ file: 'helfer.py', line: 3 });
    expect(work.work.value.open).toBe('helfer.py');
    expect(jump.target.value).toEqual({ file: 'helfer.py', line: 3 });
  });

  it('is a new one every time: the same line can be asked for twice', () => {
    const { jump } = createPage();
    const place = { file: 'main.py', line: 1 };
    jump.to(place);
    const first = jump.target.value;
    jump.to(place);
    expect(jump.target.value).toEqual(first);
    expect(jump.target.value).not.toBe(first);
  });

  it('is not the mark of a wrong line, which the next run takes away', async () => {
    const { run, jump } = createPage();
    jump.wrong.value = { file: 'main.py', line: 1, device: 0 };
    jump.to({ file: 'main.py', line: 5 });
    expect(jump.wrong.value).toEqual({ file: 'main.py', line: 1, device: 0 });
    await run.start();
    expect(jump.wrong.value).toBeNull();
  });
});
