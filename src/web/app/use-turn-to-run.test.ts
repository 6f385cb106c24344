// @vitest-environment happy-dom
import { afterEach, describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { createPage, type TestPage } from './testing/page';
import { startRun } from './testing/run';
import { setWindow } from './testing/mount-on';
import { useTurnToRun } from './use-turn-to-run';

/** A page in a window of this size that turns to what a run shows. */
function pageIn(width: number, height: number, robot: string, wish: Parameters<typeof createPage>[0] = {}): TestPage {
  setWindow(width, height);
  const page = createPage(wish);
  page.settings.change({ robot, device: 'microbit-v2' });
  page.scope.run(() => useTurnToRun(page));
  return page;
}

async function tabAfterStart(page: TestPage): Promise<string> {
  await startRun(page);
  await nextTick();
  return page.layout.tab.value;
}

describe('a run that is started on a phone', () => {
  afterEach(() => setWindow(1024, 768));

  it('turns from the program to the arena, where the robot drives', async () => {
    expect(await tabAfterStart(pageIn(390, 844, 'maqueen-lite'))).toBe('arena');
  });

  it('turns to the board where no robot is chosen', async () => {
    expect(await tabAfterStart(pageIn(390, 844, 'none'))).toBe('board');
  });

  it('stays where the pupil looks already', async () => {
    const page = pageIn(390, 844, 'maqueen-lite');
    page.layout.tab.value = 'console';
    expect(await tabAfterStart(page)).toBe('console');
  });

  it('stays where a host shows no arena', async () => {
    const page = pageIn(390, 844, 'maqueen-lite', { settings: { parts: ['code', 'console'] } });
    expect(await tabAfterStart(page)).toBe('code');
  });

  it('changes nothing on a larger page', async () => {
    expect(await tabAfterStart(pageIn(820, 1180, 'maqueen-lite'))).toBe('code');
  });
});
