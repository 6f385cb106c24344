/** A program whose serial text is the same in a frame as on the command line. */
export interface SerialProgram {
  readonly name: string;
  readonly source: string;
  /** Text typed once this ends the output, and the output that follows it, so that both sides know when to go on. */
  readonly typed?: { readonly at: string; readonly text: string; readonly until: string };
  /** Runs on into the REPL, whose text is compared as well. */
  readonly usesRepl?: boolean;
}

/** Prints, errors, input, display, music, radio, sleep, recursion, memory, long output, other scripts, the REPL. */
export const serialPrograms: readonly SerialProgram[] = [
  {
    name: 'prints',
    source: 'print("hallo")\nprint(1, 2.5, "x", sep=";", end="!\\n")\nfor i in range(5): print(i * i)\n',
  },
  { name: 'an exception in a function', source: 'def f(x):\n    return 1 // x\n\nprint("before")\nf(0)\n' },
  { name: 'a syntax error', source: 'print("never")\nwhile True\n    pass\n' },
  { name: 'an unknown name', source: 'from microbit import *\nprint("x")\ndisplay.shw(1)\n' },
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
  { name: 'music', source: 'import music\nmusic.play(["c4:1", "e4:1", "g4:1"])\nprint(music.get_tempo())\n' },
  {
    name: 'radio',
    source:
      'import radio\nradio.on()\nradio.config(group=7)\nradio.send("hi")\nprint(radio.receive())\nradio.off()\ntry:\n    radio.send("x")\nexcept Exception as e:\n    print(repr(e))\n',
  },
  {
    name: 'sleep',
    source:
      'from microbit import *\nfor i in range(4):\n    sleep(50)\n    print(i)\nprint(running_time() >= 200, temperature(), button_a.was_pressed())\n',
  },
  {
    name: 'recursion',
    source: 'def f(n):\n    return 0 if n == 0 else 1 + f(n - 1)\nprint(f(20))\ndef g():\n    return g()\ng()\n',
  },
  {
    name: 'too little memory',
    source:
      'x = []\ntry:\n    while True: x.append("y" * 1000)\nexcept MemoryError:\n    x = None\n    print("full")\n',
  },
  { name: 'long output', source: 'for i in range(400):\n    print(i, "abcdefghijklmnopqrstuvwxyz" * 2)\n' },
  {
    name: 'other scripts',
    source: 'print("Grüezi, ça va? è già 42 €")\nprint("日本語", "🙂")\nprint(len("ü"), "ä".encode())\n',
  },
  { name: 'chance', source: 'import random\nrandom.seed(3)\nprint([random.randint(1, 6) for _ in range(10)])\n' },
  {
    name: 'the REPL after the end',
    source: 'a = 6\nprint("done")\n',
    typed: { at: '>>> ', text: 'print(a * 7)\r', until: '42' },
    usesRepl: true,
  },
];
