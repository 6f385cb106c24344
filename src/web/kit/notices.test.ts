import { describe, expect, it } from 'vitest';
import { effectScope, shallowRef } from 'vue';

import { createNotices, type Notice, type NoticesModel } from './notices';

const cleared: Notice = { kind: 'ok', key: 'notice.cleared' };
const made = (): NoticesModel => effectScope().run(() => createNotices())!;

describe('a notice', () => {
  it('goes as soon as what it offers no longer holds', () => {
    const notices = made();
    const newest = shallowRef('clear');
    notices.show({ ...cleared, holds: () => newest.value === 'clear' });
    expect(notices.current.value?.key).toBe('notice.cleared');
    newest.value = 'stroke';
    expect(notices.current.value).toBeNull();
  });

  it('does not come back with what made it go', () => {
    const notices = made();
    const newest = shallowRef('clear');
    notices.show({ ...cleared, holds: () => newest.value === 'clear' });
    newest.value = 'stroke';
    newest.value = 'clear';
    expect(notices.current.value).toBeNull();
  });

  it('stays for what an earlier one was about', () => {
    const notices = made();
    const newest = shallowRef('clear');
    notices.show({ ...cleared, holds: () => newest.value === 'clear' });
    notices.show({ kind: 'warn', key: 'notice.courseFull' });
    newest.value = 'stroke';
    expect(notices.current.value?.key).toBe('notice.courseFull');
  });
});
