# The plugin for Jekyll: the tag `river_seed`. It draws each picture once, with the command `riverseed`, into Jekyll's cache.

require "cgi"
require "digest"
require "json"
require "open3"

module RiverSeed
  # An error that the site's author can mend; it says how.
  class Error < StandardError
    def initialize(message) = super("river-seed: #{message}")
  end

  LEAST = { "Jekyll" => "4.0", "riverseed" => "0.1.0" }.freeze
  # The longer side of the picture, a PNG of some 600 kB.
  SIZE = 960
  # Pixels of a screen to a CSS pixel, in a column of 640: letters are large enough to be read.
  RATIO = "1.5"

  def self.need(program, version)
    return if Gem::Version.new(version) >= Gem::Version.new(LEAST[program])
    raise Error, "#{program} #{LEAST[program]} or newer is needed; this is #{version}"
  end

  # Runs the command without a shell, so that no word is read as one.
  def self.riverseed(*words)
    said, status = Open3.capture2e("riverseed", *words)
    status.success? ? said : raise(Error, said.strip.delete_prefix("riverseed: "))
  rescue SystemCallError => error
    raise Error, "the command `riverseed` cannot be run: #{error.message}"
  rescue ArgumentError
    raise Error, "the text holds a character that cannot be shown"
  end

  # Reads a map as the command does: the canonical link, whose edition keeps the picture and the element alike after an upgrade, a text
  # alternative, and what the element cannot draw.
  def self.read(map)
    said = riverseed("embed", "--json", "--", map)
    notices, json = said.partition(/^\{$/).then { |before, brace, rest| [before.strip, brace + rest] }
    facts = JSON.parse(json)
    tell(notices.delete_prefix("riverseed: ")) unless notices.empty?
    tell("a picture without the element for #{map.inspect}: #{facts["beyond_element"].join("; ")}") unless facts["beyond_element"].empty?
    facts
  end

  # Tells the author something that stops no build.
  def self.tell(message)
    Jekyll.logger.warn("river-seed:", message)
  end

  class Tag < Liquid::Tag
    def render(context)
      map, alt = @markup.scan(Liquid::QuotedFragment).map { |word| context.evaluate(Liquid::Expression.parse(word)) }
      raise Error, "a word or a link is wanted, as \"kauri\" or \"seed=kauri&land=valley\"" if map.to_s.strip.empty?
      facts = RiverSeed.read(map.to_s)
      link = facts["link"]
      site = context.registers[:site]
      name, width, height = picture(site, link)
      base = File.join("/", site.baseurl.to_s, "riverseed/")
      alt_or_own = alt || facts["alternative"]
      escape = ->(text) { CGI.escapeHTML(text.to_s) }
      img = %(<img src="#{base}#{name}" alt="#{escape[alt_or_own]}" width="#{width}" height="#{height}" style="display:block;width:100%;height:auto" />)
      return img unless facts["beyond_element"].empty?
      %(<script type="module" src="#{base}river-seed.js"></script><river-seed recipe="#{escape[link]}"#{%( alt="#{escape[alt]}") if alt} style="display:block">#{img}</river-seed>)
    end

    private

    # Returns the file name and the size of a map's picture, which Jekyll will write with the site's other files. The name is a hash of all
    # that decides the pixels.
    def picture(site, link)
      name = "river-seed-#{Digest::SHA256.hexdigest("#{link}, #{SIZE} at #{RATIO}")[0, 16]}.png"
      cache = File.join(site.cache_dir, "river-seed")
      path = File.join(cache, "riverseed", name)
      FileUtils.mkdir_p(File.dirname(path))
      RiverSeed.riverseed("render", link, "-o", path, "--size", SIZE.to_s, "--ratio", RATIO) unless File.exist?(path)
      file = Jekyll::StaticFile.new(site, cache, "riverseed", name)
      site.static_files << file unless site.static_files.any? { |other| other.path == file.path }
      [name, *File.binread(path, 8, 16).unpack("NN")]
    end
  end

  # Before anything is drawn: everything that has to be there is.
  Jekyll::Hooks.register :site, :after_init do |site|
    need("Jekyll", Jekyll::VERSION)
    need("riverseed", riverseed("--version")[/[\d.]+/])
    raise Error, "baseurl is a path such as \"/blog\", not \"#{site.baseurl}\"" unless site.baseurl.to_s.match?(%r{\A(/(?!/).*)?\z})
    raise Error, "the element's files are not in the folder riverseed of the site" unless File.exist?(site.in_source_dir("riverseed/river-seed.js"))
  end

  # Parts of a page in which a tag is only text: comments, scripts and styles.
  UNSEEN = %r{<!--.*?(?:-->|\z)|<(script|style)\b.*?</\1\s*>}mi

  Jekyll::Hooks.register %i[pages documents], :post_render do |page|
    raise Error, "a river-seed stands inside another: #{page.relative_path}" if page.output&.gsub(UNSEEN, "")&.match?(%r{<river-seed[\s>](?:(?!</river-seed>).)*<river-seed[\s>]}m)
  end
end

Liquid::Template.register_tag("river_seed", RiverSeed::Tag)
