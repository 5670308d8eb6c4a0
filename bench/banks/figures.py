"""Tables in Markdown."""


def best(bank, width):
    """Modes at once, or None."""
    return max((run.best for run in bank.by_width.get(width, [])), default=None)


def cell(value, form):
    return "" if value is None else format(value, form).replace(",", " ")


def row(cells):
    return "| " + " | ".join(cells) + " |"


def beside(ours, peers, widths):
    """Modes at once of every bank, and how many times as many ours rings."""
    heading = ["bank", "channels", "precision"]
    for width in widths:
        heading += [f"{width.title}, modes", "ours ×"]
    lines = [row(heading), row(["---"] * 3 + ["---:"] * 2 * len(widths))]
    for bank in [ours, *peers]:
        cells = [bank.title, bank.channels, bank.precision]
        for width in widths:
            own, other = best(ours, width), best(bank, width)
            times = own / other if own and other else None
            cells += [cell(other, ",.0f"), cell(times, ".2f")]
        lines.append(row(cells))
    return "\n".join(lines)


def own(ours, units, widths, ops):
    """What else there is to say of ours."""
    def of(figure):
        return [
            figure(width, ours.by_width[width][0]) if width in ours.by_width else None
            for width in widths
        ]

    def slots(width, run):
        rate = best(units, width)
        return 100 * ops * run.best * 48_000 / (width.lanes * rate) if rate else None

    lines = [
        row(["ours", *(width.title for width in widths)]),
        row(["---"] + ["---:"] * len(widths)),
    ]
    rates = [best(units, width) for width in widths]
    bounds = [r and w.lanes * r / (ops * 48_000) for w, r in zip(widths, rates)]
    for title, values, form in (
        ("FMAs of the machine, 10⁹ vectors a second", [r and 1e-9 * r for r in rates], ".2f"),
        (f"the most modes they allow, at {ops:g} a mode and sample", bounds, ",.0f"),
        ("share of them that ours uses, %", of(slots), ".0f"),
        ("modes if none is above 3.45 kHz", of(lambda _, run: run.low), ",.0f"),
        ("modes with all damping automated", of(lambda _, run: run.automated), ",.0f"),
        ("of steady", of(lambda _, run: run.automated / run.best), ".2f"),
        (
            "88 bodies of 60 modes, 20 strikes a second: % of a core",
            of(lambda _, run: 100 * run.keyboard),
            ".2f",
        ),
    ):
        lines.append(row([title, *(cell(value, form) for value in values)]))
    return "\n".join(lines)
