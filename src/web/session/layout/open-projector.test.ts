// @vitest-environment happy-dom
import { afterEach, describe, expect, it } from 'vitest';

import { setWindow } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { openProjector } from './open-projector';

describe('the way to the projector view', () => {
  afterEach(() => document.documentElement.classList.remove('arena-alone'));

  it('shows the arena where it was hidden', async () => {
    const page = createPage();
    page.settings.change({ showArena: false });
    await openProjector(page);
    expect([page.layout.isShown.value.arena, page.alone.isAlone.value, page.alone.hasSide.value]).toEqual([true, true, true]); // prettier-ignore
  });

  it('turns a phone to the arena', async () => {
    setWindow(390, 800);
    const page = createPage();
    page.layout.tab.value = 'code';
    await openProjector(page);
    expect([page.layout.tab.value, page.alone.hasSide.value]).toEqual(['arena', true]);
  });
});
