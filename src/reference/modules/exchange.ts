import { fn, module, value, values } from '../table';

/** Sources: micropython-microbit-v2, src/codal_port/modradio.c, modlog.c, modpower.c. */
export const radio = module('radio', {
  on: fn('() -> None'),
  off: fn('() -> None'),
  config: fn(
    '(*, length: int = 32, queue: int = 3, channel: int = 7, power: int = 6, address: int = 0x75626974, group: int = 0, data_rate: int = RATE_1MBIT) -> None',
  ),
  reset: fn('() -> None'),
  send: fn('(message: str) -> None'),
  receive: fn('() -> str | None'),
  send_bytes: fn('(message: bytes) -> None'),
  receive_bytes: fn('() -> bytes | None'),
  receive_bytes_into: fn('(buffer: bytearray) -> int | None'),
  receive_full: fn('() -> tuple[bytes, int, int] | None'),
  ...values('int', ['RATE_1MBIT', 'RATE_2MBIT']),
});

export const log = module('log', {
  set_labels: fn('(*labels: str, timestamp: int | None = SECONDS) -> None'),
  add: fn('(data: dict) -> None', '(**data) -> None'),
  delete: fn('(full: bool = False) -> None'),
  set_mirroring: fn('(serial: bool) -> None'),
  ...values('int', ['MILLISECONDS', 'SECONDS', 'MINUTES', 'HOURS', 'DAYS']),
});

export const power = module('power', {
  off: fn('() -> None'),
  deep_sleep: fn(
    '(ms: int | None = None, wake_on: Pin | Button | tuple | None = None, run_every: bool = True) -> None',
  ),
});

/** Sources: modantigravity.c, modlove.c, modthis.c there. */
export const antigravity = module('antigravity', {});
export const love = module('love', { badaboom: fn('() -> None') });
export const zen = module('this', { authors: fn('() -> str') });

/** Source: modmachine.c there. */
export const machine = module('machine', {
  unique_id: fn('() -> bytes'),
  reset: fn('() -> None'),
  freq: fn('() -> int'),
  disable_irq: fn('() -> int'),
  enable_irq: fn('(state: int) -> None'),
  time_pulse_us: fn('(pin: Pin, pulse_level: int, timeout_us: int = 1000000, /) -> int'),
  mem8: value('memory'),
  mem16: value('memory'),
  mem32: value('memory'),
});
