import type { RadioNews, SentPacket } from './radio-report';
import type { Report } from './report';

/** Collects the news of the devices, and adds them to their reports. */
export class RadioReport {
  private readonly sent: { packets: SentPacket[]; count: number }[] = [];

  add(news: readonly RadioNews[]): void {
    for (const [device, { packets, count }] of news.entries()) {
      const all = (this.sent[device] ??= { packets: [], count: 0 });
      for (const packet of packets) all.packets.push(packet);
      all.count = count;
    }
  }

  /** The report with all packets received so far. */
  in(report: Report): Report {
    const of = (device: number) => ({
      radio: this.sent[device]?.packets ?? [],
      radioSent: this.sent[device]?.count ?? 0,
    });
    return { ...report, ...of(0), devices: report.devices.map((one, device) => ({ ...one, ...of(device) })) };
  }
}
