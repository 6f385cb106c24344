import { expect, it, vi } from 'vitest';

import { newKey } from './new-key';

it('orders what came within one millisecond, or after the clock was set back, by the order in which it came', () => {
  vi.spyOn(Math, 'random').mockReturnValueOnce(0.999).mockReturnValueOnce(0).mockReturnValueOnce(0.5);
  vi.spyOn(Date, 'now').mockReturnValueOnce(2000).mockReturnValueOnce(2000).mockReturnValueOnce(1000);
  const keys: string[] = [];
  for (let index = 0; index < 3; index++) keys.push(newKey(keys.map((key) => ({ key }))));
  expect(keys).toEqual(['2000999', '2001000', '2001001']);
  vi.restoreAllMocks();
});
