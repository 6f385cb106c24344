import { describe, expect, it } from 'vitest';

import { allowedOrigins } from './origins';

describe('the origins that may command the page', () => {
  it('are all where neither the page nor its address names any', () => expect(allowedOrigins(null, [])).toBeNull());

  it('are those that the page names, as origins', () =>
    expect(allowedOrigins(' https://a.example/  https://b.example:8443/path ', [])).toEqual([
      'https://a.example',
      'https://b.example:8443',
    ]));

  it('are narrowed by the address, never widened', () => {
    const page = 'https://a.example https://b.example';
    expect(allowedOrigins(page, ['https://b.example', 'https://c.example'])).toEqual(['https://b.example']);
    expect(allowedOrigins(page, ['https://c.example'])).toEqual([]);
    expect(allowedOrigins(null, ['https://c.example'])).toEqual(['https://c.example']);
  });

  it('are none where the page names none', () => expect(allowedOrigins('', [])).toEqual([]));

  it('are pages without an origin only when they are named as such', () => {
    expect(allowedOrigins('file:///a.html data:text/html,x', [])).not.toContain('null');
    expect(allowedOrigins('null', [])).toEqual(['null']);
  });
});
