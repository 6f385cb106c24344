// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';

import { addressWithoutLink } from './follow-link';

describe('an address once its link is open', () => {
  it.each([
    ['loses the course', '/?task=closed-line', '/'],
    ['keeps other parameters', '/?lang=de&world=square&theme=dark', '/?lang=de&theme=dark'],
    ['keeps those behind the sign #?', '/a/#?code=abc&lang=fr', '/a/#?lang=fr'],
    ['loses a project', '/?lang=de#p=1.abc', '/?lang=de'],
    ['loses a run', '/#r=1.abc', '/'],
    ['keeps the page that it also names', '/?task=closed-line#task', '/#task'],
    ['keeps a page that begins like a project', '/?task=closed-line#robots/callibot', '/#robots/callibot'],
  ])('%s: %s', (_, given, left) => {
    expect(addressWithoutLink(new URL(given, 'https://school.example'))).toBe(left);
  });

  it('shows the parts that it is told', () => {
    const given = new URL('https://school.example/?code=a&show=arena#?show=arena');
    expect(addressWithoutLink(given, ['arena', 'code'])).toBe('/?show=arena%2Ccode');
  });
});
