import { expect, test } from './app';
import { IN_ONE_ENGINE } from './engines';
import { canUndo, clearAll, listOf, openEditor, withMouse } from './pupil';
import { by } from './parts';
import { withKeys } from './keys';

test(
  'with the mouse: the eraser cuts a line and takes a block in one drag, and one undo brings both back',
  IN_ONE_ENGINE,
  async ({ app }) => {
    const pupil = withMouse(app);
    await openEditor(app);
    await clearAll(app);
    await pupil.chooseTool('pen');
    await pupil.draw([[200, 300], [500, 300]]); // prettier-ignore
    await pupil.chooseTool('block');
    await pupil.draw([[350, 500]]);
    const before = await listOf(app);
    expect(before).toHaveLength(3); // with the robot's start
    await pupil.chooseTool('eraser');
    await pupil.draw([[350, 200], [350, 400], [350, 510]]); // prettier-ignore
    const after = await listOf(app);
    expect(after).toHaveLength(3); // the start and two pieces of the line
    expect(after.some((row) => row.includes('Block'))).toBe(false);
    await app.click(by('undo'));
    await expect.poll(() => listOf(app)).toEqual(before);
  },
);

test('by keyboard: the eraser takes the block under the crosshair', IN_ONE_ENGINE, async ({ app }) => {
  const pupil = withKeys(app);
  await openEditor(app);
  await clearAll(app);
  await pupil.chooseTool('block');
  await pupil.draw([[700, 400]]);
  expect(await listOf(app)).toHaveLength(2);
  await pupil.chooseTool('eraser');
  await pupil.draw([[700, 400]]);
  await expect.poll(() => listOf(app)).toHaveLength(1);
  expect(await canUndo(app)).toBe(true);
});
