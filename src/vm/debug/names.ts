import type { Memory } from '../run/values';

/** py/qstr.h: qstr_pool_t. */
const POOL = { previous: 0, before: 4, lengths: 20, texts: 24 } as const;
/** The highest bit of `before` says whether the pool is sorted. */
const COUNT_BITS = 0x7fffffff;

/** MicroPython's interned names, by number. */
export class Names {
  private readonly known = new Map<number, string>();

  /** @param interned address of the pointer to the last pool */
  constructor(
    private readonly memory: Memory,
    private readonly interned: number,
  ) {}

  of(name: number): string {
    const known = this.known.get(name);
    if (known !== undefined) return known;
    const text = this.read(name);
    this.known.set(name, text);
    return text;
  }

  private read(name: number): string {
    const { memory } = this;
    let pool = memory.word(this.interned);
    while (pool !== 0 && name < (memory.word(pool + POOL.before) & COUNT_BITS)) pool = memory.word(pool);
    const place = name - (memory.word(pool + POOL.before) & COUNT_BITS);
    const length = memory.byte(memory.word(pool + POOL.lengths) + place);
    return memory.text(memory.word(pool + POOL.texts + 4 * place), length);
  }
}
