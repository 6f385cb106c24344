/** A program whose serial text is the same in a frame as on the command line. */
export interface SerialProgram {
  readonly name: string;
  readonly source: string;
  /** Text typed once this ends the output, and the output that follows it, so that both sides know when to go on. */
  readonly typed?: { readonly at: string; readonly text: string; readonly until: string };
  /** Runs on into the REPL, whose text is compared as well. */
  readonly usesRepl?: boolean;
}

/**
 * All that a frame does otherwise with the text of a program: prints, an error, input, what waits for the display, long output,
 * other scripts, the REPL. What programs say is the VM's, in any engine (`sameness`, the tests of `src/vm` and `src/board`).
 */
export const serialPrograms: readonly SerialProgram[] = [
  {
    name: 'prints',
    source: 'print("hallo")\nprint(1, 2.5, "x", sep=";", end="!\\n")\nfor i in range(5): print(i * i)\n',
  },
  { name: 'an exception in a function', source: 'def f(x):\n    return 1 // x\n\nprint("before")\nf(0)\n' },
  {
    name: 'input',
    source: 'name = input("Name? ")\nprint("Hallo", name, len(name))\n',
    typed: { at: 'Name? ', text: 'Ada\r', until: '' },
  },
  {
    name: 'the display',
    source:
      'from microbit import *\ndisplay.show(Image.HEART)\nfor x in range(5): print(display.get_pixel(x, 2))\ndisplay.scroll("Hi", delay=20)\nprint(Image.HAPPY)\n',
  },
  { name: 'long output', source: 'for i in range(400):\n    print(i, "abcdefghijklmnopqrstuvwxyz" * 2)\n' },
  {
    name: 'other scripts',
    source: 'print("Grüezi, ça va? è già 42 €")\nprint("日本語", "🙂")\nprint(len("ü"), "ä".encode())\n',
  },
  {
    name: 'the REPL after the end',
    source: 'a = 6\nprint("done")\n',
    typed: { at: '>>> ', text: 'print(a * 7)\r', until: '42' },
    usesRepl: true,
  },
];
