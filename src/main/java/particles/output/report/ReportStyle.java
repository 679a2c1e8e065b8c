package particles.output.report;

/** The style sheet and script of a report, for screens, phones and paper. */
final class ReportStyle {
    /**
     * The style sheet. On paper no picture is divided.
     */
    static final String CSS = """
            :root { color-scheme: light; }
            body { margin: 0 auto; padding: 1rem; max-width: 76rem; color: #1b1b1f; background: #fff;
              font: 1rem/1.5 system-ui, "DejaVu Sans", sans-serif; overflow-wrap: break-word; }
            h1 { font-size: 1.7rem; }
            section { border-top: 2px solid #c9ccd3; margin-top: 2.5rem; padding-top: 1rem; }
            .task { color: #555a64; font-size: 0.875rem; margin: 0 0 0.3rem; }
            .command { white-space: nowrap; }
            .failure { white-space: pre-line; border-left: 4px solid #a00; padding: 0.3rem 0.8rem;
                  background: #fff3f2; }
            nav { background: #f3f4f7; padding: 0.8rem 1rem; }
            figure { margin: 1.2rem 0; }
            img { max-width: 100%; max-height: 95vh; }
            figcaption { color: #3a3e47; font-size: 0.9rem; margin-top: 0.4rem; }
            .table { overflow-x: auto; }
            table { border-collapse: collapse; font-size: 0.8rem; }
            th, td { padding: 0.2rem 0.45rem; border-bottom: 1px solid #d9dbe0; text-align: left; vertical-align: top; }
            td.number { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
            td:first-child { white-space: nowrap; }
            th { vertical-align: bottom; border-bottom: 2px solid #8a8f99; }
            .ends th { font-weight: normal; white-space: nowrap; }
            th button { all: unset; cursor: pointer; font-weight: bold; }
            th button:focus-visible { outline: 2px solid #0a4b9c; }
            th.number { text-align: right; }
            th button::after { content: " \\2195"; color: #8a8f99; }
            th[aria-sort=ascending] button::after { content: " \\2191"; color: inherit; }
            th[aria-sort=descending] button::after { content: " \\2193"; color: inherit; }
            @media print {
              @page { margin: 12mm; }
              body { font-size: 10pt; max-width: none; padding: 0; }
              h1, h2, h3, .task { break-after: avoid; }
              h2, figure, .table, tr { break-inside: avoid; }
              figure.animation { display: none; }
              img { max-height: 185mm; }
              .table { overflow: visible; }
              table { font-size: 7.5pt; width: 100%; }
            }
            """;

    /** The script, without the two characters that XML requires to be escaped and HTML does not allow escaped. */
    static final String SCRIPT = """
            "use strict";
            document.querySelectorAll("th button").forEach(button => button.onclick = () => {
              const head = button.closest("th"), body = head.closest("table").tBodies[0];
              const up = head.getAttribute("aria-sort") !== "ascending", sign = up ? 1 : -1;
              const text = row => row.cells[head.cellIndex].textContent;
              const number = row => parseFloat(row.cells[head.cellIndex].dataset.value);
              const last = x => isNaN(x) ? sign * Infinity : x;
              head.parentNode.querySelectorAll("th").forEach(other => other.removeAttribute("aria-sort"));
              head.setAttribute("aria-sort", up ? "ascending" : "descending");
              Array.from(body.rows).sort((a, b) => sign * (head.className === "number"
                ? last(number(a)) - last(number(b)) || 0 : text(a).localeCompare(text(b))))
                .forEach(row => body.append(row));
            });
            """;

    private ReportStyle() {
    }
}
