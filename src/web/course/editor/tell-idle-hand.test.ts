// @vitest-environment happy-dom
import { describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { createPage } from '../../app/testing/page';
import { startRun } from '../../app/testing/run';

const pose = { xMm: 300.4, yMm: 200, headingDeg: 30.2 };

/** A page where the hand has put the robot elsewhere before any run. */
async function afterHand() {
  const page = createPage();
  page.hand.pose.value = pose;
  await nextTick();
  return page;
}
const setupOf = (page: ReturnType<typeof createPage>) =>
  page.sent.flatMap((message) => (message.type === 'run' ? [message.setup] : [])).at(-1);

describe('the hand while no run goes on', () => {
  it('is told that the next run begins at the start, and so it does', async () => {
    const page = await afterHand();
    expect(page.notices.current.value?.key).toBe('notice.handRobot');
    await startRun(page);
    expect(page.hand.pose.value).toBeNull();
    expect(setupOf(page)?.inputs?.map(({ action }) => action.type)).toEqual(['arena-senses']); // no hand
    expect(page.notices.current.value).toBeNull();
  });

  it('can make its place the start, in one step that can be undone', async () => {
    const page = await afterHand();
    const before = page.work.scene.value.robot;
    page.notices.current.value?.action?.run();
    await vi.dynamicImportSettled();
    expect(page.work.scene.value.robot).toMatchObject({ at: [300, 200], heading: 30 });
    expect([page.hand.pose.value, page.notices.current.value]).toEqual([null, null]);
    page.mode.enter('build');
    page.editor.undo();
    expect(page.work.scene.value.robot).toEqual(before);
  });

  it('is told of a block that everything is back in its place, and nothing else is offered', async () => {
    const page = createPage();
    page.hand.blocks.value = { a: pose };
    await nextTick();
    expect(page.notices.current.value).toMatchObject({ key: 'notice.handBlock' });
    expect(page.notices.current.value?.action).toBeUndefined();
    page.hand.reset();
    expect(page.notices.current.value).toBeNull();
  });
});
