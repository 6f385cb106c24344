import { describe, expect, it } from 'vitest';
import { smallerPython, uncommentedPython } from './smaller';

describe('a program in fewer letters', () => {
  it('has no comments, docstrings, empty lines and needless spaces', () => {
    const text = [
      '"""About this."""',
      'import os  # why',
      '',
      'def f(a, b = 1):',
      '    """Says it."""',
      '    if a  and b:',
      '        return - a',
      '    return "# no comment"',
      '',
    ].join('\n');
    expect(smallerPython(text)).toBe('import os\ndef f(a,b=1):\n if a and b:\n  return-a\n return "# no comment"\n');
  });

  it('keeps a body that was a docstring alone, and a text that is used', () => {
    expect(smallerPython('def f():\n    "nothing"\nx = "used"\n')).toBe('def f():\n pass\nx="used"\n');
  });

  it('keeps the lines of a text over several lines, and joins those in brackets', () => {
    expect(smallerPython('x = """a\n\n    # b\n"""\ny = [\n    1,\n    2\n]\n')).toBe(
      'x="""a\n\n    # b\n"""\ny=[1,2]\n',
    );
  });

  it('keeps a text with mistakes as it is', () => {
    expect(smallerPython('def f(:\n  # why\n')).toBe('def f(:\n  # why\n');
  });
});

describe('a program without what is said about it', () => {
  it('has neither comments nor docstrings, and each line in its place', () => {
    const text = '"""Anna\nand Ben"""\nx = "# no"  # by Anna\ndef f():\n    """Ben"""\n# end\nf()\n';
    expect(uncommentedPython(text)).toBe('\n\nx = "# no"  \ndef f():\n    pass\n\nf()\n');
    expect(uncommentedPython('# Anna\nx = (\n')).toBe('\nx = (\n');
  });
});
