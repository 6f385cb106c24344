// @vitest-environment happy-dom
import { mount } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { latePart, noticeMissingParts } from './late-part';
import { lateView } from './late-view';
import { createNotices } from './notices';

describe('a late part that does not come', () => {
  const notices = createNotices();
  let stop = (): void => undefined;
  beforeEach(() => {
    vi.useFakeTimers();
    stop = noticeMissingParts(notices);
  });
  afterEach(() => {
    stop();
    notices.close();
    vi.useRealTimers();
  });
  const miss = (): boolean => window.dispatchEvent(new Event('vite:preloadError'));

  it('is told, with the way out, to whoever has asked for it by a press', () => {
    document.body.dispatchEvent(new Event('click', { bubbles: true }));
    vi.advanceTimersByTime(29_000);
    miss();
    expect(notices.current.value).toBe(latePart);
    expect(latePart.action?.key).toBe('notice.reload');
  });

  it('is told also after a key', () => {
    document.body.dispatchEvent(new Event('keydown', { bubbles: true }));
    miss();
    expect(notices.current.value).toBe(latePart);
  });

  it('is not missed if it was fetched ahead', () => {
    miss();
    expect(notices.current.value).toBeNull();
    document.body.dispatchEvent(new Event('click', { bubbles: true }));
    vi.advanceTimersByTime(31_000);
    miss();
    expect(notices.current.value).toBeNull();
  });

  it('comes with its style sheet at the second try, which the loader itself asks for once only', () => {
    document.head.innerHTML = '<link rel="stylesheet" href="/late.css"><link rel="modulepreload" href="/late.js">';
    const [sheet, script] = Array.from(document.querySelectorAll('link'));
    for (const lost of [sheet, script]) lost?.dispatchEvent(new Event('error'));
    document.body.dispatchEvent(new Event('click', { bubbles: true }));
    const [again, same] = Array.from(document.querySelectorAll('link'));
    expect(again?.getAttribute('href')).toBe('/late.css');
    expect(again, 'a new element: only such a one is fetched').not.toBe(sheet);
    expect(same).toBe(script);
    again?.dispatchEvent(new Event('error'));
    window.dispatchEvent(new Event('online'));
    expect(document.querySelector('link'), 'lost once more').not.toBe(again);
  });

  it('is asked for again by the notice where it is a view, and when the connection is back', async () => {
    const load = vi.fn(() => Promise.reject(new Error('no network')));
    mount(lateView(load));
    await vi.advanceTimersByTimeAsync(0);
    expect([load.mock.calls.length, notices.current.value]).toEqual([1, null]);
    await vi.advanceTimersByTimeAsync(10_000);
    expect(load, 'nobody has pressed: it tries by itself').toHaveBeenCalledTimes(4);
    document.body.dispatchEvent(new Event('click', { bubbles: true }));
    window.dispatchEvent(new Event('online'));
    await vi.advanceTimersByTimeAsync(0);
    expect(load).toHaveBeenCalledTimes(5);
    expect(notices.current.value?.action?.key).toBe('notice.again');
    notices.current.value?.action?.run();
    expect(load).toHaveBeenCalledTimes(6);
  });

  it('is told no more once the page is left', () => {
    stop();
    document.body.dispatchEvent(new Event('click', { bubbles: true }));
    miss();
    expect(notices.current.value).toBeNull();
  });
});
