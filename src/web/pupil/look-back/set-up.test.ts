// @vitest-environment happy-dom
import { describe, expect, it, vi } from 'vitest';
import { effectScope, nextTick, shallowRef } from 'vue';

import { openLayer } from '../../kit/overlays/overlays';
import type { SessionParts } from '../../session/models/session';
import { setUp } from './set-up';

const escape = (): boolean => dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape' }));

describe('Escape in the past', () => {
  it('leads out of it after all that lies over it, and the keyboard goes on in the arena', async () => {
    document.body.innerHTML = '<section class="pane-arena"><div role="application" tabindex="0"></div></section>';
    const current = shallowRef('drive');
    const enter = vi.fn((mode: string) => void (current.value = mode));
    const scope = effectScope();
    scope.run(() => setUp({ mode: { current, enter } } as unknown as SessionParts));
    escape();
    expect(enter).not.toHaveBeenCalled();
    current.value = 'lookBack';
    const close = openLayer({ requestClose: () => close() });
    escape();
    expect(current.value).toBe('lookBack');
    escape();
    await nextTick();
    expect([current.value, document.activeElement?.getAttribute('role')]).toEqual(['drive', 'application']);
    escape();
    expect(enter).toHaveBeenCalledOnce();
    scope.stop();
  });
});
