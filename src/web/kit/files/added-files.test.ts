// @vitest-environment happy-dom
import { expect, it } from 'vitest';

import { chosenFiles } from './added-files';

it('chosen files have their path in the folder that was chosen', () => {
  const file = (name: string): File => new File([''], name);
  const own = Object.defineProperty(file('main.py'), 'webkitRelativePath', { value: '7b/Ada/main.py' });
  expect(chosenFiles([own, file('Ben.py')]).map(({ path }) => path)).toEqual(['7b/Ada/main.py', 'Ben.py']);
});
