import type { BoardCosts } from './board-type';

/** Costs on an nRF52833 at 64 MHz with this family of firmwares: micro:bit V2 and Calliope mini 3 alike. */
export const nrf52833CostsUs: BoardCosts = {
  bytecodeUs: 1, // fitted together with allocationUs to the next row's measurement
  allocationUs: 9, // fitted: 13,700 rounds of `number = number * 1.001 - 1.001` take 442 ms (kevinjwalters/micropython-examples)
  callUs: 5, // chosen: a C function of a few hundred instructions at 64 MHz
  analogReadUs: 91, // codal-nrf52 NRF52ADC.cpp: time of one channel's 14-bit conversion
  // Estimated from micropython-microbit-v2 microbit_image.c, as there are no measurements: two pixels share a byte, and
  // each is read and written by a function of its own.
  pixelMoveUs: 1, // one read and one write: about 60 cycles
  pixelSumUs: 1.6, // two reads, one write and the limits: about 100 cycles
  pixelScaleUs: 2.2, // and a product and a sum in doubles, which the processor does in software: about 140 cycles
  pixelTextUs: 0.8, // the text is traversed twice, or extended character by character: about 50 cycles
  showUs: 25, // estimated: 25 pixels are read and put into the display's buffer, some 60 cycles each (microbit_display.c)
  motionUs: 10, // estimated: the sample is turned into the board's coordinates first (codal-core Accelerometer.cpp)
  scaleUs: 25, // estimated: named arguments, and five sums and products of decimals in software (modmicrobit.c)
  neopixelUs: 70, // estimated: the class is Python on the board, too: some 70 bytecodes for three colours (neopixel.py)
  toneUs: 30, // estimated: named arguments, pin and mixer are set up (modmusic.c)
  printByteUs: 1_000_000 / 11_520, // 115200 baud, ten bits a byte: 86.8 µs
  i2cGapUs: 10, // codal-nrf52 NRF52I2C.cpp asks every 10 µs whether a transfer is done
  i2cProbeUs: 1000, // codal-nrf52 NRF52I2C.cpp: a transfer without bytes ends by its 1 ms time-out
  ws2812ByteUs: 10, // WS2812B datasheet: 1.25 µs a bit, hence 30 µs an LED
  ws2812SetupUs: 125, // measured by users, micropython-microbit-v2 issue #227: 125 … 300 µs besides the bits
  radioPacketUs: 700, // micropython-microbit-v2 drv_radio.c: between packets sent one after the other
  // The log is in the flash memory of the chip behind the USB socket: codal-microbit-v2 MicroBitUSBFlashManager.cpp
  // sends 8 bytes of command and fetches 9 of answer over the board's own I2C bus, 400 kHz, nine bits a byte. Erasing a
  // page and the journal are left out.
  logLineUs: 17 * 22.5,
  logByteUs: 22.5 + 42.5 / 4, // and that chip writes a word of four bytes in 42.5 µs (nRF52833 product specification)
};
