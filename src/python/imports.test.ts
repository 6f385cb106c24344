import { describe, expect, it } from 'vitest';

import { foreignModules, importedModules, modulesImportedBy } from './imports';

const lines = (...texts: string[]): string => texts.join('\n');

describe('the modules that a program imports', () => {
  it('are found whatever the form of the import', () => {
    const source = lines('import a, b as c', 'from d import *', '  import e.f', '# import g', 'print("import h")');
    expect(importedModules(source)).toEqual(['a', 'b', 'd', 'e']);
    expect(importedModules('try: import a\nexcept ImportError: b = 1; import c')).toEqual(['a', 'c']);
    expect(importedModules('from a import (b,  # first\n  c)\nimport d.e as f')).toEqual(['a', 'd']);
  });

  it('are there as soon as they are named in a line that is being written', () => {
    for (const line of ['from a', 'from a ', 'from a imp', 'from a import', 'from a import (b,', 'import a,', 'import a as '])
      expect(importedModules(`${line}\nx = 1\n`), line).toEqual(['a']); // prettier-ignore
  });

  it('are not those that a text or comment speaks of, nor files beside the program', () => {
    expect(importedModules('"""\nimport a\n"""\n# from b import c\n')).toEqual([]);
    expect(importedModules('from . import a\nfrom .b import c\n')).toEqual([]);
  });

  it('are still there while a quote, a bracket or a docstring is left open anywhere', () => {
    const program = lines('# Drive', 'from a import *', 'import b', '', 'x = f(1)', 'while True:', '    f(x)', '');
    for (const open of ['(', '[', '{', '"', "'", '"""', ':', '=', '\\', '. ', 'if ', 'def '])
      for (let at = 0; at <= program.length; at += 1) {
        if (/^(from a|import b)/m.test(program.slice(program.lastIndexOf('\n', at - 1) + 1, at + 20))) continue;
        expect(importedModules(program.slice(0, at) + open + program.slice(at)), `${open} at ${at}`).toEqual([
          'a',
          'b',
        ]);
      }
  });

  it('are those of all programs of a project; its own files are not from elsewhere', () => {
    const files = { 'main.py': 'import drive, a', 'drive.py': 'from b import c', 'notes.txt': 'import d' };
    expect(modulesImportedBy(files)).toEqual(new Set(['drive', 'a', 'b']));
    expect(foreignModules(files)).toEqual(new Set(['a', 'b']));
  });
});
