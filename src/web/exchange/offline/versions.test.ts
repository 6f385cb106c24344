import { describe, expect, it } from 'vitest';

import { isMessage, pageUrl, versionLock, versionLocks } from './versions';

describe('the file behind an address', () => {
  it('is the same whatever the address asks of the page', () => {
    expect(pageUrl('https://school.example/sim/index.html?lang=fr#courses')).toBe(
      'https://school.example/sim/index.html',
    );
  });

  it('is index.html in a folder', () => {
    expect(pageUrl('https://school.example/sim/?flag=sw')).toBe('https://school.example/sim/index.html');
  });
});

describe('the versions of the open pages', () => {
  it('are known by their locks, and by no other', () => {
    const url = 'https://school.example/assets/index-12345678.js';
    expect(versionLocks([versionLock(url), 'parcours.tab.abc', versionLock(url)])).toEqual([url, url]);
  });
});

describe('a message to the service worker', () => {
  it.each([null, 'take-over', 7, {}, { type: 'install' }, []])('is not %j', (data) => {
    expect(isMessage(data)).toBe(false);
  });

  it('asks it to take over or to tidy up', () => {
    expect(isMessage({ type: 'take-over' })).toBe(true);
    expect(isMessage({ type: 'tidy' })).toBe(true);
  });
});
