import { describe, expect, it } from 'vitest';

import { isSafari, platformOf } from './browser-facts';

const MAC = 'Mozilla/5.0 (Macintosh; Intel Mac OS X 10_15_7)';
const SAFARI = `${MAC} AppleWebKit/605.1.15 (KHTML, like Gecko) Version/17.5 Safari/605.1.15`;
const CHROME_IPAD = 'Mozilla/5.0 (iPad; CPU OS 17_5 like Mac OS X) AppleWebKit/605.1.15 (KHTML, like Gecko) CriOS/126.0.0.0 Mobile/15E148 Safari/604.1'; // prettier-ignore

describe('the kind of device that a browser runs on', () => {
  it.each([
    ['Windows', 'Mozilla/5.0 (Windows NT 10.0; Win64; x64) AppleWebKit/537.36', 0, 'computer'],
    ['Windows with a screen to touch', 'Mozilla/5.0 (Windows NT 10.0; Win64; x64) AppleWebKit/537.36', 10, 'computer'],
    ['a Mac', SAFARI, 0, 'computer'],
    ['an iPad that calls itself a Mac', SAFARI, 5, 'ipad'],
    ['an iPhone', 'Mozilla/5.0 (iPhone; CPU iPhone OS 17_5 like Mac OS X)', 5, 'ipad'],
    ['Chrome on an iPad', CHROME_IPAD, 5, 'ipad'],
    ['Android', 'Mozilla/5.0 (Linux; Android 14; Pixel 8) AppleWebKit/537.36 Chrome/126.0', 5, 'android'],
    ['a Chromebook', 'Mozilla/5.0 (X11; CrOS x86_64 14541.0.0) AppleWebKit/537.36 Chrome/126.0', 0, 'chromebook'],
    ['Linux', 'Mozilla/5.0 (X11; Linux x86_64; rv:128.0) Gecko/20100101 Firefox/128.0', 0, 'computer'],
  ] as const)('%s', (_, userAgent, maxTouchPoints, platform) => {
    expect(platformOf({ userAgent, maxTouchPoints })).toBe(platform);
  });

  it('tells Safari from other browsers on an iPad', () => {
    expect(isSafari({ userAgent: SAFARI, maxTouchPoints: 5 })).toBe(true);
    expect(isSafari({ userAgent: CHROME_IPAD, maxTouchPoints: 5 })).toBe(false);
  });
});
