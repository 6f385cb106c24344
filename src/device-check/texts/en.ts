import type { RuleTexts } from './texts';

/** English. */
export const en: RuleTexts = {
  'f-string': 'The {board} does not know f-strings. Write this instead: {instead}',
  'text-method': 'Texts have no {name}() on the {board}. Write this instead: {instead}',
  'bytes-hex': 'Bytes have no {name}() on the {board}. Write this instead: {instead}',
  'bytes-fromhex': 'There is no {name}() on the {board}. Write this instead: {instead}',
  'star-arguments':
    'The {board} allows only one * in a call and no plain values after it. Join the lists first: f(*(a + b))',
  'dict-union': 'The {board} cannot join two dictionaries with |. Write this instead: {instead}',
  'pow-three': 'On the {board}, pow() takes only two numbers. Write this instead: {instead}',
  'round-whole': 'The {board} cannot round a whole number to places. Make a decimal number of it first: {instead}',
  'next-default':
    'On the {board}, next() takes no second value. Catch the end with try: … except StopIteration: instead.',
  'not-implemented': 'There is no NotImplemented on the {board}. Stop with raise TypeError() instead.',
  'builtin-name': 'There is no {name}() on the {board}. exec() runs a text directly.',
  'int-bytes': 'On the {board}, {name}() needs the order of the bytes. Write {instead}',
  'special-method':
    'The {board} does not call {name}: this operator does not work with your own classes there. Write a method such as {instead}() and call it yourself.',
  'reverse-method': 'The {board} does not call {name}. Put your object left of the operator, or call a method.',
  'attribute-hook': 'The {board} does not call {name}. Change the value with a method of your own.',
  descriptor: 'The {board} does not call {name}. Use @property instead.',
  'function-attribute': 'Functions have no {name} on the {board}. Write the name as a text yourself.',
  'slice-attribute': 'On the {board}, ranges such as [1:3] do not tell their {name}. Write a method with two values.',
  'array-slice': 'The {board} cannot replace a whole range in {name}. Replace the bytes in a loop.',
  'math-name': 'There is no {name} on the {board}. Write this instead: {instead}',
  'math-missing': 'There is no {name} on the {board}. Write a function of your own for it.',
  deque: 'There is no deque on the {board}. Use a list with append() and pop(0).',
  'time-name':
    'The {board} does not know {name}, for it has no clock. running_time() gives the milliseconds since the start.',
  'type-name': 'Only editors know {name}; the {board} does not. Leave it out.',
  module: 'There is no module {name} on the {board}. Leave it out, or add a file {name}.py.',
  'module-instead': 'There is no module {name} on the {board}. Perhaps this helps you: {instead}',
  'newer-name': '{name} came with newer firmware. The {board} with the chosen firmware stops here with an error.',
  'float-digits': 'The {board} calculates with about 7 digits. The last ones of {name} get lost.',
  'float-range': '{name} is too big for the {board}: it takes it for infinity.',
};
