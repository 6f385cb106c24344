import { describe, expect, it } from 'vitest';

import { nearName } from './near-name';

const robot = [
  'forward',
  'backward',
  'left',
  'right',
  'leftArc',
  'rightArc',
  'getDistance',
  'setSpeed',
  'irLeft',
  'irRight',
];

describe('the name that was meant', () => {
  it.each([
    ['forwart', 'forward'],
    ['Forward', 'forward'],
    ['fowrard', 'forward'],
    ['getdistance', 'getDistance'],
    ['setspeed', 'setSpeed'],
    ['leftarc', 'leftArc'],
    ['rigth', 'right'],
    ['lef', 'left'],
    ['getDistanse', 'getDistance'],
  ])('of %s is %s', (written, meant) => expect(nearName(written, robot)).toBe(meant));

  it('is not guessed where nothing is near', () => {
    for (const written of ['x', 'abstand', 'vor', 'los', 'irLinks']) expect(nearName(written, robot)).toBeNull();
  });

  it('is not another short word', () => {
    expect(nearName('led', ['len', 'abs'])).toBeNull();
    expect(nearName('lne', ['len', 'abs'])).toBe('len');
  });

  it('is not guessed where two are equally near', () => {
    expect(nearName('irMight', ['irRight', 'irLight'])).toBeNull();
  });
});
